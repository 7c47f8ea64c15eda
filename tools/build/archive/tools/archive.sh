# Sourced by tools/release: makes the archive of the tools for others, from build/portable.
name=$FILM-tools-$version${unclean:+-unclean}-linux-x86_64
linux=$work/tools/$name programs=(compare pack radiosity)
mkdir -p "$linux/doc/pack" "$linux/doc/radiosity"
for program in "${programs[@]}"; do
    [ -x "$BUILD/portable/$program" ] || fail "$BUILD/portable/$program is not built: leave out --built, or build the target portable"
    cp "$BUILD/portable/$program" "$linux"
done
TEXTS=$TEXTS/tools text README.txt
cp "$ODRAZ/LICENSE" "$linux/LICENSE.txt"
cp "$TEXTS/tools/NOTICES.txt" "$linux"
cp "$ODRAZ/packer/README.md" "$ODRAZ/packer/report.png" "$linux/doc/pack"
cp "$ODRAZ"/tools/radiosity/{README.md,METHOD.md,vault.png} "$linux/doc/radiosity"
cp "$ODRAZ/tools/SIZE_GATE.md" "$linux/doc"
seal "$linux" "${programs[@]}"
cd "$work/tools"
archive "$name"
cd "$work"
verify "$name.tar.gz" "$linux" tar -xzf "$work/$name.tar.gz"
mv "$name.tar.gz" "$to"
sha256sum "$to/$name.tar.gz"
