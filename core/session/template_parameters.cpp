#include "core/session/template_parameters.h"

#include "core/session/operation_script.h"

#include <algorithm>
#include <cmath>

namespace fff {

Result<bool> truthOf(const CommandParameters &parameters, const char *key, bool otherwise)
{
    const std::string *text = textOf(parameters, key);
    if (!text)
        return otherwise;
    if (*text != "true" && *text != "false")
        return failure(ErrorCode::BadValue, key, {*text, "true or false"});
    return *text == "true";
}

Result<int> wholeOf(const CommandParameters &parameters, const char *key, int otherwise, int least,
                    int most)
{
    const Result<double> number = numberOf(parameters, key, otherwise);
    if (!number)
        return tl::unexpected(number.error());
    if (!(*number >= least && *number <= most) || *number != std::floor(*number))
        return failure(ErrorCode::BadValue, key,
                       {*textOf(parameters, key), "a whole number from " + std::to_string(least) +
                                                      " to " + std::to_string(most)});
    return static_cast<int>(*number);
}

Result<Template> templateOf(const Document &document, const CommandParameters &parameters,
                            const char *key)
{
    const std::vector<TemplatePointer> &all = document.templates;
    const std::string *name = textOf(parameters, key);
    const auto found =
        name ? std::find_if(all.begin(), all.end(),
                            [name](const TemplatePointer &one) { return one->name == *name; })
             : all.end() - (all.empty() ? 0 : 1);
    if (found == all.end())
        return failure(ErrorCode::BadValue, key,
                       {name ? *name : "nothing", "the name of a template"});
    return **found;
}

} // namespace fff
