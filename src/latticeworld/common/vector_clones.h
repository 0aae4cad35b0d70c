#ifndef LATTICEWORLD_COMMON_VECTOR_CLONES_H_
#define LATTICEWORLD_COMMON_VECTOR_CLONES_H_

// Stands before a function with a hot loop over floats: the compiler makes it twice, for any
// processor and for one with AVX2, and the program takes the one that fits where it runs. Both give
// the same bits where contraction is off (-ffp-contract=off). Elsewhere than on x86-64 with GCC it
// says nothing; nor under sanitizers, which are not ready when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(LATTICEWORLD_PLAIN)
#define LATTICEWORLD_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define LATTICEWORLD_VECTOR_CLONES
#endif

#endif  // LATTICEWORLD_COMMON_VECTOR_CLONES_H_
