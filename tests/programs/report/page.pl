# Reads a page that pack --html made.
#   page.pl PAGE ID      prints an element of its data, unpacked: tables, bytes, costs, code
#   page.pl PAGE sums    checks that its figures add up to the file; prints the numbers of bytes, stretches, instructions
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
    print element($what);
    exit;
}

my $tables = decode_json(element('tables'));
my ($bytes, $code, @costs) = (element('bytes'), element('code'), unpack 'C*', element('costs'));
my $wrong = 0;
sub need { my ($there, $what) = @_; print STDERR "    $what\n" and $wrong = 1 unless $there }
sub sum { my $all = 0; $all += $_ for @_; return $all }
$costs[$_->[0]] = $_->[1] for @{$tables->{high}};
need(@costs == $tables->{size} && length($bytes) == $tables->{size}, 'not a cost for each byte');
# Each byte is in one stretch, whose cost is the sum of its bytes' costs
my $at = 0;
for (@{$tables->{stretches}}) {
    my ($begin, $size, $units) = @$_;
    need($begin == $at && $size > 0, "a stretch at $begin, not at $at");
    need(sum(@costs[$begin .. $begin + $size - 1]) == $units, "a stretch at $begin that costs something else");
    $at += $size;
}
need($at == $tables->{size}, 'stretches end before the program');
# Instructions lie in the program and do not overlap
my ($end, $count) = (0, 0);
for (split /\n/, $code) {
    if (/^@(.*)/) {
        need(hex $1 >= $end, "instructions at $1 overlap those before");
        $end = hex $1;
    } else {
        $end += hex substr $_, 0, 1;
        ++$count;
    }
}
need($end <= $tables->{size}, 'instructions are not in the program');
print "$tables->{size} bytes of $tables->{file}, ", scalar @{$tables->{stretches}}, " stretches, $count instructions\n";
exit $wrong;
