# One command each; see README.md. JOBS=n limits the parallel jobs.
JOBS ?= $(shell nproc)
MAKEFLAGS += --no-print-directory

SOURCES = $(shell find exact filtered history engine certify corpus library python apps bench tests \
  -name '*.h' -o -name '*.cpp')

.PHONY: build demo test lists bench api site packages format clean

build:
	cmake --preset release
	cmake --build --preset release -j $(JOBS)

# Installs what is missing, builds, simulates, checks, draws into demo/.
demo:
	@JOBS=$(JOBS) scripts/demo.sh

# Ends with ctest's own summary.
test:
	scripts/install-deps.sh test
	cmake --preset release
	cmake --build --preset release -j $(JOBS)
	ctest --preset release -j $(JOBS)

# Seconds, after a build: what a change of a comment or a document can break.
lists:
	clang-format --dry-run -Werror $(SOURCES)
	ctest --preset release -j $(JOBS) -L lists

# About a quarter of an hour; see docs/benchmarks.md.
bench:
	scripts/install-deps.sh bench
	cmake --preset bench
	bench/run.sh

# The reference of the library, in build/api/html; needs doxygen.
api:
	scripts/api-reference.sh

# The documents as a site, in build/site, with a player, a certifier and the references; see CONTRIBUTING.md.
site:
	scripts/install-deps.sh site
	scripts/site.sh

# Debian packages and an archive, made and checked, in packages/; needs root. See docs/install.md.
packages:
	scripts/install-deps.sh packages
	cmake --preset dist
	cmake --build --preset dist -j $(JOBS)
	scripts/check-packages.sh build-dist packages

format:
	clang-format -i $(SOURCES)

clean:
	rm -rf build build-* demo packages
