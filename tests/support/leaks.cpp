// What the leak checker of the address sanitizer is to pass over.

extern "C" const char* __lsan_default_suppressions();

/// lib3mf 1.8 reads archives by libzip and leaves a little of each behind.
extern "C" const char* __lsan_default_suppressions() { return "leak:libzip.so\n"; }
