# What a page of pack --html holds.
#   page.pl PAGE ID      prints an element of its data, unpacked: tables (a row a line), bytes, costs, code
#   page.pl PAGE sums    checks that its figures add up to the file, and prints bytes, stretches and instructions
use strict;
use warnings;
use Compress::Zlib;
use JSON::PP;
use MIME::Base64;
my ($path, $what) = @ARGV;
open(my $in, '<:raw', $path) or die "$path: $!\n";
my $page = do { local $/; <$in> };
sub element {
    my ($id) = @_;
    $page =~ m{<script type="application/octet-stream" id="$id">([A-Za-z0-9+/=]*)</script>} or die "$path has no $id\n";
    return uncompress(decode_base64($1)) // die "$path: $id cannot be unpacked\n";
}
binmode STDOUT;
if ($what ne 'sums') {
    my $text = element($what);
    $text =~ s/(?<=\[)(?=\[)|(?<=\],)(?=\[)|(?="budget":)|(?<=,)(?="file":)/\n/g if $what eq 'tables';
    print $text;
    exit;
}

my $tables = decode_json(element('tables'));
my ($bytes, $code, @costs) = (element('bytes'), element('code'), unpack 'C*', element('costs'));
my ($wrong, $unit) = (0, $tables->{unit} * 8);
sub need { my ($there, $what) = @_; print STDERR "    $what\n" and $wrong = 1 unless $there }
sub sum { my $all = 0; $all += $_ for @_; return $all }
$costs[$_->[0]] = $_->[1] for @{$tables->{high}};
my $program = sum(@costs);
need(@costs == $tables->{size} && length($bytes) == $tables->{size}, 'not a cost for each byte');
for my $kind (qw(rooms objects sections symbols)) {
    my @rows = @{$tables->{$kind}} or next;
    need(sum(map { $_->[2] } @rows) == $tables->{file} * $unit, "the $kind are not the file");
    need(sum(map { $_->[1] } @rows) == $tables->{size}, "the bytes of $kind are not the program");
    need(keys %{{map { $_->[0] => 1 } @rows}} == @rows, "a name stands twice among $kind");
    need(sum(map { $_->[3] } @rows) == $tables->{before}{file} * $unit, "the $kind before are not the file before")
        if $tables->{before} && defined $rows[0][3];
}
# Each byte is in one stretch, and what parts cost is what their stretches cost
my ($at, %cost, %size) = (0);
for (@{$tables->{stretches}}) {
    my ($begin, $size, $units, @of) = @$_;
    need($begin == $at && $size > 0, "a stretch at $begin, not at $at");
    need(sum(@costs[$begin .. $begin + $size - 1]) == $units, "a stretch at $begin that costs something else");
    $at += $size;
    for my $kind (qw(sections objects rooms symbols)) {
        my $row = shift @of;
        next if $row < 0;
        $cost{$kind}{$row} += $units;
        $size{$kind}{$row} += $size;
    }
}
need($at == $tables->{size}, 'stretches end before the program');
for my $kind (keys %cost) {
    my $row = 0;
    for (@{$tables->{$kind}}) {
        need(($size{$kind}{$row} // 0) == $_->[1], "$_->[0] has other bytes than its stretches");
        need($cost{$kind}{$row} == $_->[2], "$_->[0] costs something else than its stretches") if exists $cost{$kind}{$row};
        ++$row;
    }
}
# Instructions lie in the program and do not overlap
my ($next, $end, $count) = (0, 0, 0);
for (@{$tables->{runs}}) {
    my ($begin, $instructions) = @$_;
    need($begin >= $end, "instructions at $begin overlap those before");
    for (1 .. $instructions) {
        my ($form, $shift) = (0, 0);
        while () {
            my $part = ord substr $code, $next++, 1;
            $form |= ($part & 127) << $shift;
            last if $part < 128;
            $shift += 7;
        }
        $begin += hex substr $tables->{forms}[$form], 0, 1;
        ++$count;
    }
    $end = $begin;
}
need($next == length $code && $count == $tables->{instructions} && $end <= $tables->{size}, 'instructions are not all');
print "$tables->{size} bytes of $tables->{file}, ", scalar @{$tables->{stretches}}, " stretches, $count instructions\n";
exit $wrong;
