"""The degenerate-case corpus: short exact descriptions from which corpus/cases/ is made.

scene.py, case.py and history.py say what a case is; geometry.py helps to describe one; wrong.py
writes what faulty implementations would; build.py makes the files. All others are families.
"""
