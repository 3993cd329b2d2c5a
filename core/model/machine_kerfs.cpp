#include "core/model/machine_kerfs.h"

#include <algorithm>
#include <string>

namespace fff {

namespace {

auto placeOf(const std::vector<MachineKerf> &kerfs, std::string_view machine)
{
    return std::lower_bound(
        kerfs.begin(), kerfs.end(), machine,
        [](const MachineKerf &one, std::string_view key) { return one.machine < key; });
}

} // namespace

std::optional<double> kerfOn(const Stock &stock, std::string_view machine)
{
    const auto known = placeOf(stock.kerfs, machine);
    return known != stock.kerfs.end() && known->machine == machine ? std::optional(known->kerf)
                                                                   : std::nullopt;
}

void setKerf(Stock &stock, std::string_view machine, double kerf)
{
    stock.kerf = kerf;
    if (machine.empty())
        return;
    const auto known = placeOf(stock.kerfs, machine);
    const auto at = stock.kerfs.begin() + (known - stock.kerfs.cbegin());
    if (at != stock.kerfs.end() && at->machine == machine)
        at->kerf = kerf;
    else
        stock.kerfs.insert(at, {std::string(machine), kerf});
}

Document cutOn(Document document, std::string_view machine)
{
    for (std::shared_ptr<const Stock> &pointer : document.stocks) {
        const std::optional<double> kerf = kerfOn(*pointer, machine);
        if (!kerf || *kerf == pointer->kerf)
            continue;
        Stock next = *pointer;
        next.kerf = *kerf;
        pointer = std::make_shared<const Stock>(std::move(next));
    }
    return document;
}

} // namespace fff
