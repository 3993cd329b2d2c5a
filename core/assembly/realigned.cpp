#include "core/assembly/realigned.h"

namespace fff {

namespace {

/// The row with its mates at their new places; those that are gone are left out.
template <class T>
std::vector<T> moved(const std::vector<T> &row, int T::*mate, const std::vector<int> &newPlaces)
{
    std::vector<T> result;
    result.reserve(row.size());
    for (const T &item : row) {
        const int place = newPlaces[static_cast<std::size_t>(item.*mate)];
        if (place < 0)
            continue;
        result.push_back(item);
        result.back().*mate = place;
    }
    return result;
}

} // namespace

Realigned realigned(const Assembly &before, const std::vector<int> &places)
{
    std::vector<int> newPlaces(before.boxes.size(), -1);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i] >= 0)
            newPlaces[static_cast<std::size_t>(places[i])] = static_cast<int>(i);
    Realigned result;
    Assembly &assembly = result.assembly;
    assembly.boxes.resize(places.size());
    assembly.slits.resize(places.size());
    SharedRows<Slit>::Editor slits(assembly.slits);
    std::vector<JointList::NewRow> rows;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] < 0)
            continue;
        const auto place = static_cast<std::size_t>(places[i]);
        assembly.boxes[i] = before.boxes[place];
        slits.set(i, moved(before.slits[place], &Slit::guest, newPlaces));
        std::vector<Joint> row = moved(before.joints.rows()[place], &Joint::b, newPlaces);
        for (Joint &joint : row)
            joint.a = static_cast<int>(i);
        rows.push_back({i, std::move(row)});
    }
    result.hasNewIds = assembly.joints.replace(places.size(), std::move(rows));
    return result;
}

} // namespace fff
