#!/bin/sed -Ef
# Plain comments as those that Doxygen reads: before a declaration, at the end of its line, and the
# first of a file as that of the file.
1s|^// |/** @file */\n/// |
s|^( *)// |\1/// |
s|([;,{]) +// |\1  ///< |
