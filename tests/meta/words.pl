#!/usr/bin/perl
# words.pl RULES FILE...: what in the texts that users read breaks the rules of plain English. For each finding one line
# FILE:LINE: what was found. In .h and .cpp files these texts are the string literals, neighbouring ones joined, and in
# *.bug the first line; in scenes title and description; in all other files everything but code. Exit status 1 if
# something was found.
use strict;
use warnings;

my $longest_sentence = 30;  # words; formulas, numbers, paths and code are none

my ($rules_file, @files) = @ARGV;
my $found = 0;

# [pattern, what to write instead, exceptions]; the file describes its columns.
sub read_rules {
  open my $in, '<', $rules_file or die "$rules_file: cannot be read\n";
  my @rules;
  while (my $line = <$in>) {
    chomp $line;
    next if $line =~ /^(#|\s*$)/;
    my ($pattern, $instead, $except) = split /\t+/, $line;
    die "$rules_file:$.: expected PATTERN, tab, INSTEAD\n" unless defined $instead;
    push @rules, [qr/\b(?:$pattern)\b/i, $instead, defined $except ? qr/\b(?:$except)\b/i : undef];
  }
  return @rules;
}
my @rules = read_rules();
my $any = join '|', map { "(?:$_->[0])" } @rules;
$any = qr/$any/;

sub report {
  my ($file, $line, $what) = @_;
  print "$file:$line: $what\n";
  $found = 1;
}

sub check_words {
  my ($file, $line, $text) = @_;
  return unless $text =~ $any;
  for my $rule (@rules) {
    my ($pattern, $instead, $except) = @$rule;
    my $rest = $text;
    $rest =~ s/$except/ /g if defined $except;
    report($file, $line, "\"$1\": write $instead") while $rest =~ /($pattern)/g;
  }
}

sub words_of {
  my ($sentence) = @_;
  return grep { /^[\(\["'*_]*[A-Za-z][a-z]*(?:[-'][A-Za-z]+)*[\)\]"'*_,;:.?!]*$/ } split ' ', $sentence;
}

sub check_sentences {
  my ($file, $line, $text) = @_;
  $text =~ s/`[^`]*`/ /g;
  $text =~ s/\b(ch|sec|vs|e\.g|i\.e|ed|al|No)\. /$1 /g;
  for my $sentence (split /[.?!]["')*_]*(?=\s|$)|\\n|\{\}\{\}|\|/, $text) {
    my $count = () = words_of($sentence);
    report($file, $line, "a sentence of $count words, expected at most $longest_sentence: " . substr($sentence, 0, 60))
      if $count > $longest_sentence;
  }
}

sub check_text {
  check_words(@_);
  check_sentences(@_);
}

# Scenes, shaders, SVG and other text for programs.
sub is_code {
  my ($text) = @_;
  return $text =~ /viewport_size|projection_plane_d|^<\w|void main|^\s*\w+ \{|\w+ = \(/ || $text !~ /[a-z]{2}/;
}

sub check_source {
  my ($file, $code) = @_;
  my $line = 1;
  my ($text, $text_line);
  my $flush = sub {
    check_text($file, $text_line, $text) if defined $text && !is_code($text);
    undef $text;
  };
  while ($code =~ m{\G(?:(?<space>\s+|//[^\n]*|/\*.*?\*/)
                      |R"(?<end>[^(\s]*)\((?<raw>.*?)\)\g{end}"
                      |"(?<plain>(?:[^"\\\n]++|\\.)*+)"
                      |'(?:[^'\\\n]|\\[^'\n]+|\\')'
                      |\#[ ]*include[^\n]*
                      |[A-Za-z0-9_']+|[^\s"/A-Za-z0-9_'#]+|.)}gcxs) {
    my ($whole, $literal, $space) = ($&, $+{raw} // $+{plain}, $+{space});
    if (defined $literal) {
      ($text, $text_line) = ('', $line) unless defined $text;
      $text .= $literal;
    } elsif (!defined $space) {
      $flush->();
    }
    $line += ($whole =~ tr/\n//);
  }
  $flush->();
}

# Paragraphs of a page; code and what stands between the lines "words: off" and "words: on" is left out.
sub check_page {
  my ($file, $page) = @_;
  my ($text, $start, $code, $off) = ('', 1, 0, 0);
  my $number = 0;
  for my $line (split /\n/, "$page\n\n") {
    ++$number;
    $off = 1 if $line =~ /words: off/;
    $off = 0 if $line =~ /words: on\b/;
    $code = !$code if $line =~ /^\s*```/;
    my $prose = !$off && !$code && $line !~ /^\s*(```|<!--|build\/bin|#!)/;
    (my $plain = $line) =~ s/`[^`]*`/ /g;
    check_words($file, $number, $plain) if $prose;
    if (!$prose || $line =~ /^\s*($|[-*#|>]|\d+\.\s)/) {
      check_sentences($file, $start, $text);
      ($text, $start) = ('', $number);
    }
    $text .= " $line" if $prose;
  }
  check_sentences($file, $start, $text);
}

# Title and description; the rest is for the program.
sub check_scene {
  my ($file, $scene) = @_;
  my $number = 0;
  for my $line (split /\n/, $scene) {
    ++$number;
    check_text($file, $number, $2) if $line =~ /^\s*(title|description)\s*=\s*"(.*)"/;
  }
}

for my $file (@files) {
  open my $in, '<', $file or die "$file: cannot be read\n";
  local $/;
  my $content = <$in>;
  if ($file =~ /\.bug$/ && $content =~ /\A(.*)/) { check_text($file, 1, $1); next }
  if ($file =~ /\.(h|cpp)$/) { check_source($file, $content) }
  elsif ($file =~ /\.scene$/) { check_scene($file, $content) }
  else { check_page($file, $content) }
}
exit $found;
