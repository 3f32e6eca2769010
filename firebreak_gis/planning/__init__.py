"""A plan from what was asked to what is written: design, check, judgement, comparison, outputs."""
