// Included twice by uniforms.comp: a second copy would define the function twice.
float nested_value() { return 42.0; }
