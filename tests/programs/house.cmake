# Tests of this film and its tools, which a new film (tools/new-film) does not have

# odraz_scripts(FUNCTION FOLDER NAME SECONDS...): calls FUNCTION(NAME SECONDS FOLDER/NAME) for each test
function(odraz_scripts function folder)
    set(rest ${ARGN})
    while(rest)
        list(POP_FRONT rest name seconds)
        cmake_language(CALL ${function} ${name} ${seconds} ${folder}/${name})
    endwhile()
endfunction()
odraz_scripts(odraz_script .
    binary 10
    doctor 2
    house 1
    install 2
    ledger 1
    measure 2
    memcheck 30
    new_film 2
    odr 8
    pack_any 8
    pack_process 6
    packed 2
    packing 4
    pages 1
    panel 10
    pictures 10
    playing 10
    radiosity 8
    radiosity_atlas 3
    radiosity_errors 8
    radiosity_gltf 1
    radiosity_models 3
    radiosity_pictures 1
    radiosity_resume 8
    radiosity_study 10
    radiosity_transfer 8
    radiosity_view 15
    radiosity_view_transfer 10
    release 30
    render 15
    report 3
    rocket 18
    screens 15
    shown 5
    sound 16
    tradeoff 4
    watch 10
    web 50
    window 40)
odraz_script(hostile_damaged 2 hostile/damaged 8 1)
odraz_script(hostile_killed 4 hostile/killed 6 1)
odraz_script(hostile_surroundings 15 hostile/surroundings odraz-safe)
odraz_script(hostile_words 6 hostile/words odraz-safe 40 1)
odraz_script(hostile_words_radiosity 3 hostile/words radiosity 60 1)
odraz_script(machine 4 machine odraz-safe)

# Tests of tools/test --long
function(odraz_long_script name seconds script)
    add_test(NAME ${name} CONFIGURATIONS long
        COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/${script}.sh ${CMAKE_BINARY_DIR} ${ARGN})
    odraz_long(${name} ${seconds})
endfunction()
odraz_scripts(odraz_long_script long
    binary_again 80
    busy 9000
    doubleclick 100
    live 300
    pack_kernels 120
    pack_programs 500
    report_page 60
    systems 200
    threads 120
    whole 150)
odraz_long_script(commandline_film 120 commandline packed)
odraz_long_script(hostile_damaged_often 120 hostile/damaged 400)
odraz_long_script(hostile_killed_often 60 hostile/killed 50)
odraz_long_script(hostile_surroundings_film 150 hostile/surroundings odraz)
odraz_long_script(hostile_words_film 150 hostile/words odraz 100)
odraz_long_script(hostile_words_many 150 hostile/words odraz-safe 2000)
odraz_long_script(hostile_words_pack 60 hostile/words pack 300)
odraz_long_script(hostile_words_radiosity_many 60 hostile/words radiosity 300)
foreach(reader gltf hdr obj pack picture prt rad)
    odraz_long_script(long_fuzz_${reader} 610 fuzz ${reader} 600)
endforeach()
odraz_long_script(machine_film 100 machine odraz)
odraz_long_script(memcheck_hall 600 memcheck hall)
odraz_long_script(new_film_whole 200 long/new_film)
odraz_long_script(pack_any_all 50 pack_any all)
odraz_long_script(radiosity_errors_all 60 radiosity_errors all)
odraz_long_script(radiosity_resume_all 60 radiosity_resume all)
odraz_long_script(soak 180 soak)
odraz_long_script(watch_full 40 watch full)
odraz_long_script(tradeoff_all 45 tradeoff all)

# Tests of tools/test --windows, which use Wine and run one at a time
function(odraz_windows_script name seconds script)
    add_test(NAME windows_${name} CONFIGURATIONS windows
        COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/${script}.sh ${CMAKE_BINARY_DIR})
    odraz_usual(windows_${name} ${seconds})
    set_tests_properties(windows_${name} PROPERTIES RESOURCE_LOCK wine LABELS windows)
endfunction()
odraz_scripts(odraz_windows_script windows
    packer 30
    film 130
    sound 40
    libraries 60
    window 150)
