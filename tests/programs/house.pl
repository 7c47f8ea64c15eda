# house.pl SOURCE [FILE INCLUDED]: compares all includes and all links of the tree with the knows() lines of its
# CMakeLists.txt (tools/build/rooms.cmake). Prints each violation on a line; exit status 1 if there is one. With FILE
# INCLUDED it checks this include, too, as if it were in FILE. Tests may know every room, and no room may know tests.
use strict;
use warnings;

my ($source, @planted) = @ARGV;
chdir $source or die "house.pl: cannot enter $source: $!\n";
my @files = grep { -f } split /\0/, `git ls-files -z --cached --others --exclude-standard`;
my ($includes, $links, @wrong) = (0, 0);

sub text {
    open my $file, '<', $_[0] or die "house.pl: cannot read $_[0]: $!\n";
    local $/;
    return scalar <$file>;
}

# --- Read every CMakeLists.txt: which rooms know which, and the sources and libraries of each target ---
my (%knows, %sources, @linked);
for my $list (grep { m{(^|/)CMakeLists\.txt$} && !m{^(tests|tools/film_template)/} } @files) {
    my ($room) = $list =~ m{^(.*)/} or next; # the top-level file adds rooms, no code
    my $text = text($list);
    $text =~ s/#.*//g;
    while ($text =~ /^\s*(\w+)\(([^()]*(?:\([^()]*\)[^()]*)*)\)/mg) {
        my ($command, $first, @words) = ($1, split ' ', $2);
        if ($command eq 'knows') { $knows{$first}{$_} = 1 for '', @words }
        elsif ($command =~ /^(add_library|add_executable|target_sources|host|engine_sources)$/) {
            my $target = $command eq 'engine_sources' ? 'engine' : $first;
            $sources{$target}{"$room/$_"} = 1 for 'CMakeLists.txt', grep { /\.cpp$/ } @words;
        }
        elsif ($command eq 'target_link_libraries') { push @linked, [$room, $first, $_] for @words }
    }
}

# --- Find the rooms that each room reaches, and report circles ---
my (%reach, %entered);
sub reach {
    my ($room) = @_;
    return $reach{$room} if $reach{$room};
    push(@wrong, "$room knows itself, by a circle") and return {} if $entered{$room}++;
    my %all;
    for my $other (grep { $_ } keys %{$knows{$room} // {}}) {
        -e $other || (() = glob("$other.*")) or push @wrong, "$room knows $other, which does not exist";
        %all = (%all, $other => 1, %{reach($other)});
    }
    return $reach{$room} = \%all;
}
reach($_) for sort keys %knows;

# Returns the room of a file: the file itself, with or without its suffix, or the nearest folder with a knows() line
sub room {
    my ($name) = @_;
    (my $stem = $name) =~ s/\.\w+$//;
    for (my @tried = ($name, $stem); @tried; ) {
        my $room = shift @tried;
        return $room if $knows{$room};
        push @tried, $1 if !@tried && $room =~ m{^(.*)/};
    }
    return;
}
sub may {
    my ($from, $to) = @_;
    return $from eq $to || reach($from)->{$to};
}

# --- Check every include ---
sub judge {
    my ($file, $included) = @_;
    my ($folder) = $file =~ m{^(.*)/};
    my ($to) = grep { -e } "$folder/$included", $included, "intro/$included", "packer/$included";
    return if !defined $to; # generated
    ++$includes;
    my ($from, $room) = (room($file), room($to));
    return push @wrong, "$file belongs to no room" if !defined $from;
    push @wrong, "$file includes $to" if !defined $room || !(may($from, $room) || may($from, $to));
}
my @code = grep { /\.(h|cpp|c|S)$/ && !m{^(tests|tools/film_template)/} } @files;
for my $file (@code) {
    judge($file, $_) for text($file) =~ /^\s*#\s*include\s*"([^"]+)"/mg;
}
judge(@planted) if @planted;

# --- Check system headers: the engine is freestanding; only host/linux and host/windows use the system ---
my $own = qr{^intro/(maker/|record\.|main_debug\.|host/linux/)};
my %special = ('intro/base/avx.h' => qr{intrin\.h$}, 'intro/base/wasm.h' => qr{^wasm_simd128\.h$}, 'intro/base/gl.h' => qr{^GL/}, 'intro/host/cpu.cpp' => qr{^cpuid\.h$});
sub judge_system {
    my ($file, $header) = @_;
    return if $file =~ $own || $header =~ /^(stddef\.h|stdint\.h|initializer_list)$/;
    push @wrong, "$file includes <$header>" unless $special{$file} && $header =~ $special{$file};
}
for my $file (grep { m{^intro/} } @code) {
    judge_system($file, $_) for text($file) =~ /^\s*#\s*include\s*<([^>]+)>/mg;
}
judge_system($planted[0], $1) if @planted && $planted[1] =~ /^<(.*)>$/;

# --- Check every link: a room with sources in the target must know a room with sources in the library ---
for (@linked) {
    my ($list, $target, $library) = @$_;
    my @to = grep { defined } map { room($_) } keys %{$sources{$library} // next};
    my @from = grep { defined } map { room($_) } keys %{$sources{$target} // {}};
    ++$links;
    my $known = grep { my $from = $_; grep { may($from, $_) } @to } @from;
    push @wrong, "$target of $list links $library" if @from && !$known; # a target without sources is skipped
}

print "$_\n" for @wrong;
print "$includes includes and $links links were compared\n" unless @wrong;
die "house.pl: no code was found\n" if $includes < 20 || $links < 20;
exit(@wrong ? 1 : 0);
