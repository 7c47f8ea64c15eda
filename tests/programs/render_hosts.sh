# tools/render on hosts, by GNU parallel: the bytes are the same wherever shards are made.
. "$(dirname "$0")/rendering.sh"
skip_unless parallel
check "frames in one shard" rendered "${small[@]}" --shard 30 "$to/one"
check "a video in one shard" rendered "${small[@]}" --shard 30 "$to/one.mp4"
printf '# this machine, twice\n2/:\n\n:   # and once more\n' >"$WORK/hosts"
check "GNU parallel makes the frames" rendered "${small[@]}" --shard 4 --hosts "$WORK/hosts" "$to/hosts"
check "... the same" same_frames "$to/hosts"
check "GNU parallel makes the video" rendered "${small[@]}" --shard 4 --hosts "$WORK/hosts" "$to/hosts film.mp4"
check "... the same" same_video "$to/hosts film.mp4"
# A stand-in for ssh: the host `broken` fails when it should draw, `patient` draws only after that, and `deaf` cannot be
# reached
cat >"$WORK/ssh" <<END
#!/usr/bin/env bash
echo "\$1" >>"$WORK/reached"
case "\$*" in
"broken exec"*film\ --dump*) : >"$WORK/broke"; echo "broken: the cable is out" >&2; exit 255 ;;
"patient exec"*film\ --dump*) for ((i = 0; i < 600; i++)); do [ ! -e "$WORK/broke" ] || break; sleep 0.1; done ;;
deaf*) exit 255 ;;
esac
exec sh -c "\$2"
END
chmod +x "$WORK/ssh"
printf 'broken\npatient\n' >"$WORK/hosts"
mkdir "$WORK/there"
check "a host fails, and another takes its shards" eval 'TMPDIR=$WORK/there rendered "${small[@]}" --shard 4 --ssh "$WORK/ssh" --hosts "$WORK/hosts" "$to/retried.mp4"'
check "... the same" same_video "$to/retried.mp4"
check "... and stderr reports it" grep -q '^tools/render: frames [0-9]* to [0-9]* failed on broken: broken: the cable is out$' "$WORK/err"
check "no film is left there" test -z "$(ls "$WORK/there")"
for shell in "" SHELL=/bin/false; do # as a service has them
    rm -rf "$to/bare"*
    check "without ${shell:-SHELL} and HOME" env -u SHELL -u HOME $shell "$render" --film "$film" "${small[@]}" --shard 10 --ssh "$WORK/ssh" --hosts <(echo sound) "$to/bare.mp4"
    check "... the same" same_video "$to/bare.mp4"
done
echo broken >"$WORK/hosts"
check "no host is left" eval '! rendered "${small[@]}" --ssh "$WORK/ssh" --hosts "$WORK/hosts" "$to/none.mp4" 2>/dev/null'
check "... is reported" grep -q 'shards are not done; --resume goes on' "$WORK/err"
rm -r "$to/none.mp4.parts"
echo deaf >"$WORK/hosts"
check "a host that cannot be reached" refuses 1 "deaf does not take the film" "$render" --film "$film" --ssh "$WORK/ssh" --hosts "$WORK/hosts" "${small[@]}" "$to/none.mp4"
rm -r "$to/none.mp4.parts"
echo 'ssh -p 22 host' >"$WORK/hosts"
check "a line that is no host" refuses 1 "write [N/][USER@]HOST" "$render" --film "$film" "${small[@]}" --hosts "$WORK/hosts" "$to/none.mp4"
rm -r "$to/none.mp4.parts"
# By ssh itself, to a server of our own
if sshd=$(command -v sshd || command -v /usr/sbin/sshd) && command -v ssh-keygen >/dev/null; then
    mkdir -m 700 "$WORK/keys"
    ssh-keygen -q -t ed25519 -N '' -f "$WORK/keys/host"
    ssh-keygen -q -t ed25519 -N '' -f "$WORK/keys/user"
    [ "$(id -u)" != 0 ] || mkdir -p /run/sshd
    # Try ports until the server listens on one
    for port in $(shuf -i 20000-50000 -n 20); do
        printf '%s\n' "ListenAddress 127.0.0.1" "Port $port" "HostKey $WORK/keys/host" "AuthorizedKeysFile $WORK/keys/user.pub" \
            "StrictModes no" "UsePAM no" "PasswordAuthentication no" "PidFile none" >"$WORK/keys/sshd"
        "$sshd" -D -e -f "$WORK/keys/sshd" 2>"$WORK/keys/log" &
        server=$!
        PIDS+=($server)
        await eval "grep -q 'Server listening' '$WORK/keys/log' || gone $server"
        gone $server || break
    done
    printf '%s\n' "Host *" "HostName 127.0.0.1" "Port $port" "IdentityFile $WORK/keys/user" "UserKnownHostsFile $WORK/keys/known" \
        "StrictHostKeyChecking accept-new" "BatchMode yes" "LogLevel ERROR" >"$WORK/keys/ssh"
    printf '2/alpha\n%s@beta\n' "$(id -un)" >"$WORK/hosts"
    check "over ssh" rendered "${small[@]}" --shard 4 --ssh "ssh -F $WORK/keys/ssh" --hosts "$WORK/hosts" "$to/ssh.mp4"
    check "... the same" same_video "$to/ssh.mp4"
    check "... each shard by a connection" test "$(grep -c '^Accepted publickey' "$WORK/keys/log")" -ge 12
else
    echo "not checked: over ssh, for there is no sshd"
fi

printf '1/:\nfar\n' >"$WORK/hosts"
check "Ctrl-C ends GNU parallel" interrupted "$to/int.mp4" --ssh "$WORK/ssh" --hosts "$WORK/hosts"
check "... and all that it began" await all_gone
finish
