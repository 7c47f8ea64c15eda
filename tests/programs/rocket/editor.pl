# A stand-in for the editor of GNU Rocket, for rocket.sh. It listens on a free port of 127.0.0.1, and prints "port N". A
# film that connects must send the protocol's greeting; then its messages are printed, one a line: "track NAME",
# "row N". Orders are lines on standard input:
#   key NAME ROW VALUE INTERPOLATION   sets a key
#   row N | pause 0 | pause 1 | save
#   open FILE                          sends all keys of a document
#   hang-up                            ends the connection
use strict;
use warnings;
use IO::Select;
use IO::Socket::INET;

$| = 1;
$SIG{PIPE} = 'IGNORE';
my $listening = IO::Socket::INET->new(LocalAddr => '127.0.0.1', Listen => 1) or die "editor.pl: cannot listen: $!\n";
print 'port ', $listening->sockport, "\n";
my $all = IO::Select->new($listening, \*STDIN);
my ($film, $received, $greeted, %tracks);

sub hang_up {
    return if !$film;
    $all->remove($film);
    close $film;
    $film = undef;
    print "gone\n";
}
sub give { hang_up() if $film && !defined syswrite $film, $_[0] }
sub set_key {
    my ($name, $row, $value, $kind) = @_;
    give(pack 'C N N f> C', 0, $tracks{$name}, $row, $value, $kind) if exists $tracks{$name};
}
sub open_document {
    open my $in, '<', $_[0] or die "editor.pl: cannot read $_[0]: $!\n";
    my $name;
    while (<$in>) {
        $name = $1 if /<track name="([^"]*)/;
        set_key($name, $1, $2, $3) if /<key row="(\d+)" value="([^"]*)" interpolation="(\d+)/;
    }
}
my %orders = (
    key => \&set_key,
    row => sub { give(pack 'C N', 3, $_[0]) },
    pause => sub { give(pack 'C C', 4, $_[0]) },
    save => sub { give("\5") },
    open => \&open_document,
    'hang-up' => \&hang_up,
);

sub meet {
    hang_up();
    ($film, $received, $greeted, %tracks) = (scalar $listening->accept, '', 0);
    $all->add($film);
}
sub receive {
    sysread($film, $received, 4096, length $received) or return hang_up();
    if (!$greeted && length $received >= 19) {
        print substr($received, 0, 19, '') eq 'hello, synctracker!' ? "film\n" : "stranger\n";
        $greeted = 1;
        give('hello, demo!');
    }
    while ($greeted && length $received >= 5) {
        my ($kind, $n) = unpack 'C N', $received;
        if ($kind == 3) {
            print "row $n\n";
            substr $received, 0, 5, '';
        } elsif ($kind == 2) {
            return if length $received < 5 + $n;
            my $name = substr substr($received, 0, 5 + $n, ''), 5;
            $tracks{$name} = keys %tracks if !exists $tracks{$name};
            print "track $name\n";
        } else {
            print "nonsense\n";
            return hang_up();
        }
    }
}

my $typed = '';
while () {
    for my $ready ($all->can_read) {
        if ($ready == $listening) { meet() }
        elsif ($ready == \*STDIN) { sysread(STDIN, $typed, 512, length $typed) or exit }
        elsif ($film && $ready == $film) { receive() }
    }
    while ($typed =~ s/^(\S+) ?(.*)\n//) { $orders{$1}->(split / /, $2) }
}
