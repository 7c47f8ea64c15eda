# named.pl PAGE FILES TARGETS WORDS HELPS: prints what the page names, by `...` or as a link, that is not there: a file,
# a target or program, an option, a function. FILES: what git tracks; TARGETS: what can be built; WORDS: all words of
# the sources; HELPS: a folder of what programs print for --help.
use strict;
use warnings;
my ($page, $files, $targets, $words, $helps) = @ARGV;
sub lines { open(my $in, '<', $_[0]) or die "$_[0]: there is no such file\n"; chomp(my @lines = <$in>); return @lines }
my %file = map { $_ => 1 } lines($files);
my %target = map { $_ => 1 } lines($targets);
my %word = map { $_ => 1 } lines($words);
my %help;
opendir(my $folder, $helps) or die "$helps: there is no such folder\n";
for my $name (grep { !/^\./ } readdir $folder) {
    (my $program = $name) =~ s/.*://;
    $help{$program} .= join("\n", lines("$helps/$name"));
}
my $helps_text = join("\n", values %help); # in which programs name what they make
my %folder;
for my $name (keys %file) { $folder{$name} = 1 while $name =~ s/\/[^\/]*$// }
my ($here) = $page =~ /^(.*\/)/;
$here //= '';

sub is_there { # a file or folder, named from the top, from this page, or by the end of its path, with or without .h
    my ($name) = @_;
    $name =~ s/\/$//;
    return 1 if $name eq 'build' || $file{$name} || $folder{$name} || $file{"$here$name"} || $folder{"$here$name"};
    return scalar($target{$1} || $help{$1} || $helps_text =~ /(?<![\w\/])\Q$name\E(?![\w\/])/) if $name =~ /^build\/(?:tests\/)?([^\/]+)$/;
    return scalar grep { /(?:^|\/)\Q$name\E(?:\.\w+)?$/ } keys %file, keys %folder;
}
sub has_option {
    my ($option, $program) = @_;
    return scalar grep { defined && /(?<![\w-])\Q$option\E(?![\w-])/ } $program ? $help{$program} : values %help;
}
my ($checked, $missing) = (0, 0);
sub need { my ($there, $what) = @_; ++$checked; return if $there; print STDERR "    $what\n"; $missing = 1 }

my $text = join("\n", lines($page));
while ($text =~ /\]\((?!https?:)([^)#]+)[^)]*\)/g) {
    my $link = $1;
    my $path = "$here$link";
    1 while $path =~ s/[^\/]+\/\.\.\///;
    need(scalar($file{$path} || $folder{$path =~ s/\/$//r}), "a link to $link");
}
need($target{$_}, "--target $_") for map { split ' ' } $text =~ /--target ((?:[\w.-]+ ?)+)/g;
$text =~ s/a new file, `[^`]*`//g; # which is to be made
while ($text =~ /`([^`\n]+(?:\n\s*[^`\n]+)?)`/g) {
    (my $span = $1) =~ s/\s+/ /g;
    my ($first, @rest) = split / /, $span;
    (my $program = $first) =~ s/.*\///;
    if ($help{$program} && @rest) { # a command
        for (@rest) { need(has_option($1, $program), "$span: $first has no $1") if /^(--?[a-z][a-z-]*)/ }
    } elsif ($span =~ /^(--[a-z][a-z-]*)/) {
        need(has_option($1), "$span: no program has $1");
    } elsif ($span =~ /^(\S+)(\.\w+)\/(\.\w+)$/) { # NAME.h/.cpp
        my @both = ("$1$2", "$1$3");
        need(is_there($_), $_) for @both;
    } elsif (!@rest && ($span =~ /^[\w.-]+(?:\/[\w.*-]*)+$/ || $span =~ /\.(?:h|cpp|S|sh|pl|md|ld|py|txt|model|json|cmake)$/) && $span !~ /[A-Z]{2,}[^\/]*\.(?!md|txt)|\*|^\/|OUT|DIR|NAME|libdl|kernel32/) {
        need(is_there($span), $span);
    } else { # code: whatever looks like a name in the sources
        need($word{$1}, "$span: $1") while $span =~ /\b(k[A-Z]\w*|[A-Za-z_]\w+(?=[(<]))/g;
        need($word{$span} || $target{$span} || is_there($span), $span) if $span =~ /^[A-Za-z]\w+$/;
    }
}
die "nothing was named in $page\n" if !$checked;
exit $missing;
