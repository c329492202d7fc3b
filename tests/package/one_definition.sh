#!/usr/bin/env bash
# No two types of one name in one namespace: each is linked by the other's functions, and nothing says so.
set -euo pipefail
cd "$(dirname "$0")/../.."
git ls-files '*.cpp' '*.hpp' | perl -ne '
    chomp(my $file = $_);
    open(my $in, "<", $file) or die "$file: $!";
    local $/;
    my $text = <$in>;
    $text =~ s{//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|\x27(?:\\.|[^\x27\\])\x27}{ }gs;
    my @in;    # what is open: the name of a namespace, or of none (anonymous), of a type, of a block
    while ($text =~ /namespace\s+([\w:]*)\s*\{|\b(?:struct|class|union|enum(?:\s+class)?)\s+(?:alignas\([^)]*\)\s*)?(\w+)\s*(?:final\s*)?(?::(?!:)[^{;()=]*)?\{|[{}]/g) {
        my ($space, $type) = ($1, $2);
        if (defined $space) { push @in, "n$space" }
        elsif ($& eq "}") { pop @in }
        else {
            if (defined $type && !grep { !/^n./ } @in) { $at{join("::", map({ substr($_, 1) } @in), $type)}{$file} = 1 }
            push @in, "b";
        }
    }
    END {
        my $twice = 0;
        for my $type (sort keys %at) {
            my @files = sort keys %{$at{$type}};
            next if @files < 2;
            ++$twice;
            print "$type: @files\n";
        }
        print scalar(keys %at), " types, $twice of them defined twice\n";
        exit($twice || keys(%at) < 400);
    }'
