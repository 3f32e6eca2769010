"""How good breaks are: burnt share at every budget, and measures with intervals."""
