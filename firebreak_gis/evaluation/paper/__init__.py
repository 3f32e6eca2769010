"""The experiments of Russo, Russo, Siettos 2016 (doi 10.1371/journal.pone.0163226), to be run again."""
