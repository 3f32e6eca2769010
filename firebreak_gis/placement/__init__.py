"""What several rankings share: dissection into compartments, widening of lines, local search on fires."""
