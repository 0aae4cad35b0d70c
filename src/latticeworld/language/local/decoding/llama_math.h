#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_MATH_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_MATH_H_

#include <cstddef>

namespace latticeworld {

// Each of `count` rows of `width` divided by the root of its mean square and
// times the gains (Zhang and Sennrich 2019).
void RootMeanSquareNorm(const float* in, const float* gains, std::size_t count, std::size_t width,
                        float epsilon, float* out);

// gates[i] = gates[i] / (1 + exp(-gates[i])) * ups[i] (SwiGLU: Shazeer 2020).
void GateWithSwish(float* gates, const float* ups, std::size_t size);

// exp of each, relative error below 3e-7; below -87 it is 0.
void Exponentials(float* values, std::size_t size);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_LLAMA_MATH_H_
