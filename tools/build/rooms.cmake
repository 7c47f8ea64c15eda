# knows(ROOM OTHER...): code of this room may include and link code of these rooms, and of those that they know. A room
# is a folder, or a file, with or without its ending, that has its own rules; names are paths from the top. CMake does
# nothing with it: tests/programs/house.pl reads it and compares all includes and links with it.
function(knows room)
endfunction()
