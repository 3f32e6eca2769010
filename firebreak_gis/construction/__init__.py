"""What is to be built: segments in order, compartments between them, their lines and files."""
