# Sourced by tools/release: makes the archive of the tools for others, from build/portable.
name=$FILM-tools-$version${unclean:+-unclean}-linux-x86_64
linux=$work/tools/$name programs=(compare pack radiosity)
mkdir -p "$linux/doc"
for program in "${programs[@]}"; do
    [ -x "$BUILD/portable/$program" ] || fail "$BUILD/portable/$program is not built: leave out --built, or build the target portable"
    cp "$BUILD/portable/$program" "$linux"
done
TEXTS=$TEXTS/tools text README.txt
cp "$ODRAZ/LICENSE" "$linux/LICENSE.txt"
cp "$TEXTS/tools/NOTICES.txt" "$linux"
cd "$ODRAZ"
cp -r --parents packer/{README.md,report.png} tools/SIZE_GATE.md tools/measure/{RESULTS.md,*.svg,*.jpg} \
    tools/radiosity/{README.md,METHOD.md,vault.png,study/cube} "$linux/doc"
seal "$linux" "${programs[@]}"
cd "$work/tools"
archive "$name"
cd "$work"
verify "$name.tar.gz" "$linux" tar -xzf "$work/$name.tar.gz"
mv "$name.tar.gz" "$to"
sha256sum "$to/$name.tar.gz"
