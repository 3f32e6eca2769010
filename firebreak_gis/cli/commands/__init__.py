"""The commands, one file each; a file is found by its name and holds one `command`."""
