// SPDX-License-Identifier: Apache-2.0
/// What every sanitized program asks of its sanitizer by itself.

/// Up to LLVM 16, one block of thread-local storage of 4096 is taken for one of glibc before 2.25, with its length in front of it, and the search for leaks
/// reads whatever is there: "Tracer caught signal 11" (github.com/google/sanitizers/issues/1322).
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }
