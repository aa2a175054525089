"""Makes wheels and source archives (PEP 517), by CMake, patchelf and git.

A wheel has the package, the shared library and all libraries that these need but those that every
Linux has (PEP 600). VOROPROOF_BUILD names a finished build whose Python module is for this
interpreter; without it one is made in build-wheel.
"""

import base64
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EVERYWHERE = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z))\.so.*")
# An isolated build hides NumPy from the interpreters that it starts.
SEEING = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, env=SEEING, **options)


def answer(*command):
    return run(*command, stdout=subprocess.PIPE, text=True).stdout


def version():
    return re.search(r"project\(voroproof VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def metadata():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version()}", f"Summary: {project['description']}",
             f"License: {project['license']['text']}", f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {name}" for name in project["dependencies"]]
    for extra, names in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {name}; extra == "{extra}"' for name in names]
    lines.append("Description-Content-Type: text/markdown")
    return "\n".join(lines) + "\n\n" + (ROOT / project["readme"]).read_text()


def finished_build():
    given = os.environ.get("VOROPROOF_BUILD")
    if given:
        return Path(given)
    build = ROOT / "build-wheel"
    run("cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DVOROPROOF_TESTS=OFF", "-DVOROPROOF_VARIANTS=OFF",
        "-DVOROPROOF_PYTHON=ON", f"-DVOROPROOF_PYTHON_EXECUTABLE={sys.executable}")
    run("cmake", "--build", build, "--target", "voroproof_python", "-j", os.cpu_count() or 1)
    return build


def carried(file, known):
    """Adds the libraries that a file needs and not every system has, by name, with theirs."""
    places = dict(re.findall(r"^\s*(\S+) => (/\S+)", answer("ldd", file), re.MULTILINE))
    for name in answer("patchelf", "--print-needed", file).split():
        if EVERYWHERE.fullmatch(name) or name in known:
            continue
        known[name] = Path(places[name]).resolve()
        carried(known[name], known)
    return known


def copy_libraries(package):
    """Puts them into a folder of their own, and lets all find each other there."""
    core = next(package.glob("_core*.so"))
    folder = package.parent / "voroproof.libs"
    folder.mkdir()
    for name, place in carried(core, {}).items():
        shutil.copy(place, folder / name)
        run("patchelf", "--set-rpath", "$ORIGIN", folder / name)
    run("patchelf", "--set-rpath", "$ORIGIN/../voroproof.libs", core)
    for file in [core, *folder.iterdir()]:
        run("strip", "--strip-unneeded", file)


def tag():
    cpython = f"cp{sys.version_info.major}{sys.version_info.minor}"
    glibc = platform.libc_ver()[1].replace(".", "_")
    return f"{cpython}-{cpython}-manylinux_{glibc}_{sysconfig.get_platform().split('-', 1)[1].replace('-', '_')}"


def facts():
    """The files of the folder .dist-info but its record."""
    wheel = f"Wheel-Version: 1.0\nGenerator: voroproof\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    return {"METADATA": metadata().encode(), "WHEEL": wheel.encode(), "LICENSE": (ROOT / "LICENSE").read_bytes()}


def pack(tree, wheel):
    records = []
    info = f"voroproof-{version()}.dist-info"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        def add(name, content, mode=0o644):
            # One time for all, so that the same files make the same wheel.
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            records.append(f"{name},sha256={digest},{len(content)}")

        for file in sorted(path for path in tree.rglob("*") if path.is_file()):
            add(str(file.relative_to(tree)), file.read_bytes(), 0o755 if ".so" in file.name else 0o644)
        for name, content in facts().items():
            add(f"{info}/{name}", content)
        records.append(f"{info}/RECORD,,")
        archive.writestr(zipfile.ZipInfo(f"{info}/RECORD", (1980, 1, 1, 0, 0, 0)), "\n".join(records) + "\n")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = Path(metadata_directory) / f"voroproof-{version()}.dist-info"
    info.mkdir()
    for name, content in facts().items():
        (info / name).write_bytes(content)
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = finished_build()
    name = f"voroproof-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as work:
        package = Path(work) / "voroproof"
        shutil.copytree(build / "python" / "voroproof", package, ignore=shutil.ignore_patterns("__pycache__"))
        copy_libraries(package)
        pack(Path(work), Path(wheel_directory) / name)
    return name


def build_sdist(sdist_directory, config_settings=None):
    name = f"voroproof-{version()}"
    archive = Path(sdist_directory) / f"{name}.tar.gz"
    with tempfile.TemporaryDirectory() as work:
        described = Path(work) / "PKG-INFO"
        described.write_text(metadata())
        run("git", "-C", ROOT, "archive", f"--prefix={name}/", f"--add-file={described}", "-o", archive, "HEAD")
    return archive.name
