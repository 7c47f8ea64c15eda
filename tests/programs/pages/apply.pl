# apply.pl PAGE FOLDER: carries out the steps of PAGE, intro/show/README.md, in FOLDER, and prints the files it changed.
# A step ends in one of these, and the lines follow as a block:
#   Make a new file, `FILE`:
#   In `FILE`, before|below|above|last in|instead of `TEXT`:
# A block after a sentence that does not end with a colon is of commands, which are left to the reader.
use strict;
use warnings;
my ($page, $folder) = @ARGV;

sub slurp { open(my $in, '<', $_[0]) or die "$_[0]: there is no such file\n"; local $/; return <$in> }

sub change { # ... FILE PLACE TEXT LINES
    my ($file, $place, $text, $lines) = @_;
    my $path = "$folder/$file";
    if (!defined $place) {
        die "$file is there already\n" if -e $path;
        return $lines;
    }
    my $content = slurp($path);
    my $at = index($content, $text);
    die "$file has no '$text'\n" if $at < 0;
    my $line_begins = rindex($content, "\n", $at) + 1;
    my $line_ends = index($content, "\n", $at) + 1;
    if ($place eq 'before') { substr($content, $at, 0) = $lines }
    elsif ($place eq 'above') { substr($content, $line_begins, 0) = $lines }
    elsif ($place eq 'below') { substr($content, $line_ends, 0) = $lines }
    elsif ($place eq 'instead of') { chomp $lines; substr($content, $at, length $text) = $lines }
    else { # last in a table, which its definition opens
        $content =~ /\b\Q$text\E(\[[^\]]*\])+ = \{\n/ or die "$file has no table $text\n";
        my $end = index($content, "\n};", $+[0] - 1);
        die "$file: $text has no end\n" if $end < 0;
        substr($content, $end + 1, 0) = $lines;
    }
    return $content;
}

my ($sentence, $block, $steps) = ('', '', 0);
my $finish = sub {
    if ($block ne '' && $sentence =~ /:$/) {
        $sentence =~ /\bMake a new file, `([^`]+)`:$/ or $sentence =~ /\bIn `([^`]+)`, (before|below|above|last in|instead of) `([^`]+)`:$/
            or die "which file, and where in it? '$sentence'\n";
        my ($file, $place, $text) = ($1, $2, $3);
        my $content = change($file, $place, $text, $block);
        open(my $out, '>', "$folder/$file") or die "$folder/$file cannot be written\n";
        print $out $content;
        close($out);
        print "$file\n";
        ++$steps;
    }
    $block = '';
};
my $blank = 0;
for my $line (split /^/, slurp($page)) {
    if ($line =~ /^\s*$/) { $block .= "\n" if $block ne ''; $blank = 1; next }
    if ($line =~ /^ {7}(.*\n)/ && ($blank || $block ne '')) { $block .= $1; $blank = 0; next }
    $block =~ s/\n+$/\n/;
    $finish->();
    $sentence = '' if $blank;
    $line =~ s/^\s+|\s+$//g;
    $sentence .= ($sentence eq '' ? '' : ' ') . $line;
    $blank = 0;
}
die "$page has no steps\n" if !$steps;
