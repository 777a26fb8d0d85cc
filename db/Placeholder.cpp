// Replaced by the first repository.
