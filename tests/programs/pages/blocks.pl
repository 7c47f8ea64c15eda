# blocks.pl PAGE: the code blocks of a page in Markdown that stand by themselves, not in a list: lines of
# BLOCK COMMAND, the block's number and a command without its comment. A loop over several lines is one command.
use strict;
use warnings;
open(my $in, '<', $ARGV[0]) or die "$ARGV[0]: there is no such file\n";
my ($number, $blank, $inside, $command) = (0, 1, 0, '');
while (my $line = <$in>) {
    if ($line =~ /^\s*$/) { $blank = 1; next }
    $inside = $line =~ /^ {4}/ && ($inside || ($blank && $line !~ /^ {7}/)) ? $inside || ++$number : 0;
    $blank = 0;
    next if !$inside;
    $line =~ s/\s+#\s.*$//;
    $line =~ s/^\s+|\s+$//g;
    $command .= $command eq '' ? $line : ($command =~ /\bdo$/ ? ' ' : '; ') . $line;
    next if $command =~ /^for / && $command !~ /; done$/;
    print "$inside $command\n";
    $command = '';
}
