"""Fires: where they start, how they burn, and how many runs are spread over machines."""
