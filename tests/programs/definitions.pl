# definitions.pl SOURCE: one name, one definition. Prints every struct, class, union and enum that is defined at the
# scope of one namespace in two files, and those that lie in no namespace; exit status 1 if there is one. Names in
# anonymous namespaces are a file's own. A platform is chosen by file: linux/ and windows/ may define the same.
use strict;
use warnings;

chdir $ARGV[0] or die "definitions.pl: cannot enter $ARGV[0]: $!\n";
my @files = grep { -f && /\.(h|cpp)$/ && !m{^(tools/new_film|tests/programs)/} }
    split /\0/, `git ls-files -z --cached --others --exclude-standard`;
my $type = qr/\b(?:struct|class|union|enum(?:\s+class)?)\s+(?:alignas\([^)]*\)\s*)?(\w+)\s*(?:final\s*)?(?::[^:].*)?$/s;
my (%defined, $types);
for my $file (@files) {
    open my $input, '<', $file or die "definitions.pl: cannot read $file: $!\n";
    my $text = do { local $/; <$input> };
    $text =~ s{//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'}{}gs;
    $text =~ s/^\s*#.*(?:\\\n.*)*//mg;
    my @scopes; # a namespace's name, or undef for every other brace and for an anonymous namespace
    while ($text =~ /([^{};]*)([{};])/g) {
        my ($before, $mark) = ($1, $2);
        pop @scopes if $mark eq '}';
        next if $mark ne '{';
        if ($before =~ /namespace\s+([\w:]+)\s*$/) {
            push @scopes, $1;
            next;
        }
        if ($before =~ $type && !grep { !defined } @scopes) {
            push @{$defined{join '::', @scopes, $1}}, $file;
            ++$types;
        }
        push @scopes, undef;
    }
}
my $wrong = 0;
for my $name (sort keys %defined) {
    my %places = map { s{/(linux|windows)/}{/SYSTEM/}r => $_ } @{$defined{$name}};
    my @places = sort values %places;
    print "$name is defined in @places\n" and $wrong = 1 if @places > 1;
    print "$name of @places has no namespace\n" and $wrong = 1 if $name !~ /::/ && grep { !/^tests/ } @places;
}
die "definitions.pl: no code was found\n" if $types < 100;
print "$types types, each defined once\n" unless $wrong;
exit $wrong;
