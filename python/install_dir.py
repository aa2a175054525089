"""Prints where modules belong below the prefix that is given, relative to it.

That is the interpreter's own answer: the place of its scheme for the prefix that is on its path,
dist-packages on Debian; for any other prefix the place where an environment of that prefix looks.
"""

import os
import site
import sys
import sysconfig


def install_dir(prefix: str) -> str:
    for scheme in ("deb_system", "posix_local", "posix_prefix"):
        if scheme not in sysconfig.get_scheme_names():
            continue
        path = sysconfig.get_path("platlib", scheme)
        relative = os.path.relpath(path, prefix)
        outside = relative.startswith("..") or relative.startswith("local" + os.sep)
        if path in site.getsitepackages() and not outside:
            return relative
    base = {"base": prefix, "platbase": prefix, "installed_base": prefix, "installed_platbase": prefix}
    return os.path.relpath(sysconfig.get_path("platlib", "posix_prefix", base), prefix)


if __name__ == "__main__":
    print(install_dir(sys.argv[1]))
