# The packer's example for Windows, as Wine runs it.
. "$(dirname "$0")/wine.sh"
pack=$BUILD/pack
check "the example is built" bash "$SOURCE/packer/example/build.sh" "$pack" "$WORK" --pe
says() { # says STATUS TEXT COMMAND...: exit status and standard output
    local status=$1 text=$2 got
    shift 2
    got=$("$@" 2>"$WORK/err")
    [ $? = "$status" ] && [ "$got" = "$text" ] && [ ! -s "$WORK/err" ]
}
check "it runs" says 7 "hello, 42" "$wine" "$WORK/hello.exe"
check "by another path" says 7 "hello, 42" bash -c "cd '$WORK' && exec '$wine' ./hello.exe"
finish
