// Headers are compiled for a source: this one, which holds nothing.
