// One random surface, one random way of filling it.
#pragma once

#include "judge.hpp"
#include "random.hpp"

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::trials {

struct Trial {
    std::string words; // what it is, for a person
    surface::Sheet sheet;
    surfpath::Options options;
    bool as_paper = false; // by the method of the paper of 2022
    baselines::kipping2022::Options paper;
    Notes notes; // of making the surface
};

// Throws Error if no surface, or no source, comes of it: then it is no trial.
Trial make(std::uint64_t seed, std::uint64_t number);

struct Outcome {
    std::vector<std::string> faults;
    std::string refused; // by an Error, in its words
    Judged judged;
};

Outcome run(const Trial& trial);

} // namespace filum::trials
