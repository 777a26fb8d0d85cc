// Replaced by the first plot.
