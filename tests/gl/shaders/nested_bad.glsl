// The mistake is in line 3.
float fine() { return 1.0; }
float wrong() { return undeclared_in_nested; }
