cmake_policy(VERSION 3.25)
# Writes the bytes of the file IN to OUT, as a C++ array NAME.
file(READ ${IN} hex HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
file(WRITE ${OUT} "#pragma once\nconst unsigned char ${NAME}[] = {${bytes}};\n")
