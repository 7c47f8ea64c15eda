# knows(ROOM OTHER...): ROOM may include and link the OTHER rooms and all rooms that these know. A room is a folder, or
# a file with its own rules (its name may lack the ending); names are paths from the repository's root. CMake ignores
# these lines; tests/programs/test_house.py compares all includes and links with them.
function(knows room)
endfunction()
