# Sourced by tests of the film's sound. WORK/film has its music. Recordings are in stereo, with 48 kHz and 16 bits.
loud_from() { od -An -v -td2 -w4 "$1" | awk '$1 > 100 || $1 < -100 { from = 1 } from'; } # prints "left right" for each frame
# is_music RECORDING SECONDS MOST [LOST]: succeeds if the recording, from its first loud frame on, is the film's music
# for SECONDS, with differences of at most MOST a sample. A server may lose up to LOST frames, by default a second,
# while it starts.
is_music() {
    awk -v most="$3" -v lost="${4-48000}" -v wanted=$(($2 * 48000)) '
        function size(d) { return d < 0 ? -d : d }
        function difference(i, k,  x, y) { x = size(a[i] - l[k]); y = size(b[i] - r[k]); return x > y ? x : y }
        BEGIN { n = m = off = 0 }
        NR == FNR { l[n] = $1; r[n++] = $2; next }
        { a[m] = $1; b[m++] = $2 }
        END {
            for (k = 0; k < lost; ++k) {
                for (i = 0; i < 64 && difference(i, k + i) <= most; ++i) {}
                if (i == 64) break
            }
            if (k == lost) k = 0
            for (i = 0; i < wanted && i < m && k + i < n; ++i) if (difference(i, k + i) > off) off = difference(i, k + i)
            print "    " i + 0 " frames, from frame " k " on, off by at most " off + 0
            exit !(i == wanted && off <= most)
        }' <(loud_from "$WORK/film") <(loud_from "$1" | head -n $(($2 * 48000)))
}
is_loud() { [ "$(od -An -v -td2 -w2 "$1" | awk '{ a = $1 < 0 ? -$1 : $1; if (a > most) most = a } END { print (most > 300) }')" = 1 ]; }

# --- A PulseAudio server with a null sink, and ALSA's devices ---
unset PULSE_SERVER
export HOME=$WORK XDG_RUNTIME_DIR=$WORK/run XDG_CONFIG_HOME=$WORK/config
mkdir -m 700 "$XDG_RUNTIME_DIR"
devices() { printf '%s\n' "$@" >"$WORK/alsa.conf"; export ALSA_CONFIG_PATH=$WORK/alsa.conf; } # devices LINE...
can_serve() {
    command -v pulseaudio >/dev/null && command -v parec >/dev/null &&
        ls /usr/lib/*/alsa-lib/libasound_module_pcm_pulse.so >/dev/null 2>&1
}
serve() { # starts the server; sets server
    pulseaudio -n --daemonize=no --exit-idle-time=-1 --disallow-exit -L module-native-protocol-unix -L module-null-sink >/dev/null 2>&1 &
    server=$!
    PIDS+=($server)
    await pactl info >/dev/null 2>&1
}
record() { # record FILE: starts to record the server's sound; sets recorder
    rm -f "$1"
    parec --device=null.monitor --format=s16le --rate=48000 --channels=2 --latency-msec=20 >"$1" 2>/dev/null &
    recorder=$!
    PIDS+=($recorder)
    await test -s "$1"
}
# into_server TO SECONDS MOST [LOST]: play() plays the film until TO, and the server records its music. On a busy
# machine the film drops sound, as intended: then it is played again
into_server() { await server_records "$@"; }
server_records() {
    record "$WORK/recorded"
    play --to "$1" && kill $recorder && is_music "$WORK/recorded" "${@:2}"
}
