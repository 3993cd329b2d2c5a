// How much of a form sections show together.
#pragma once

#include "core/analysis/suggesting/suggested_cut.h"

namespace fff {

class ShownForm
{
public:
    /// The samples outlive it.
    explicit ShownForm(const FormSamples &samples) : m_samples(&samples), m_best(samples.size()) {}

    /// What is shown better, or at all, with this one; of everything, 0 … 1.
    double gainOf(const std::vector<FormSamples::Shown> &shown) const
    {
        double gain = 0.0;
        for (const FormSamples::Shown &one : shown)
            if (one.share > m_best[one.sample])
                gain += m_samples->weight(one.sample) *
                        static_cast<double>(one.share - m_best[one.sample]);
        return gain;
    }
    void add(const std::vector<FormSamples::Shown> &shown)
    {
        for (const FormSamples::Shown &one : shown)
            m_best[one.sample] = std::max(m_best[one.sample], one.share);
    }

private:
    const FormSamples *m_samples;
    std::vector<float> m_best; // of each sample
};

} // namespace fff
