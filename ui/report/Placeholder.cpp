// Replaced by the first document.
