# Tests of this film and its tools, which a new film (tools/new-film) does not have

# odraz_pytests(KIND NAME SECONDS...): calls odraz_pytest for each
function(odraz_pytests kind)
    set(rest ${ARGN})
    while(rest)
        list(POP_FRONT rest name seconds)
        odraz_pytest(${kind} ${name} ${seconds})
    endwhile()
endfunction()

odraz_pytests(usual
    binary 18   house 2   install 2   killed 4   ledger 1   machine 6   measure 2   measuring 10   memcheck 30
    new_film 2   pack_process 6   packed 4   packing 12   panel 10   pictures 10   playing 10
    radiosity 8   radiosity_atlas 3   radiosity_errors 8   radiosity_files 3   radiosity_gltf 1   radiosity_light 5
    radiosity_models 3   radiosity_pictures 1   radiosity_resume 8   radiosity_study 10   radiosity_transfer 8
    radiosity_view 15   radiosity_view_transfer 10   release 30   render 15   report 3   rocket 18   sound 16
    surroundings 15   watch 10   web 50   window 55   words 8)
odraz_pytests(long
    binary 80   busy 9000   commandline 120   doubleclick 100   killed 60   live 300   machine 100   measuring 45
    memcheck 600   new_film 200   pack_programs 600   packed 120   packing 50   radiosity_errors 60
    radiosity_resume 60   release 60   report 60   same_film 450   soak 180   surroundings 150   watch 40   words 300)
foreach(reader gltf hdr obj pack picture prt rad)
    odraz_pytest(long fuzz 610 ${reader})
endforeach()
odraz_pytests(windows # They use Wine, and run one at a time
    windows_film 220   windows_sound 40   windows_window 150)
