// The models of a history: their documents for good, what operations made of them as far as there
// is room.
#pragma once

#include "core/model/model.h"

#include <cstddef>
#include <list>
#include <memory>
#include <unordered_map>

namespace fff {

using ModelPointer = std::shared_ptr<const Model>;

/// A model as a step of the history holds it.
struct KeptModel
{
    ModelPointer drawn;               // its document, without what operations made of it
    std::weak_ptr<const Model> whole; // the same object where no operation works

    const Document &document() const { return drawn->document; }
};

using KeptModelPointer = std::shared_ptr<KeptModel>;

/// Holds the models that were asked for last, together no more than so many bytes besides what
/// their documents take and the newest one, which somebody else holds anyway. What they share is
/// counted once. Not for several threads at once.
class KeptModels
{
public:
    /// Ninety steps under a row of fifty ribs, five where each has a size of its own. What is not
    /// there any more costs as much as the edit did.
    static constexpr std::size_t kRoom = 2u << 20; // bytes

    explicit KeptModels(std::size_t room = kRoom) : m_room(room) {}

    KeptModelPointer keep(ModelPointer model);
    /// The very object where it still lives, else an equal one; where it comes out as `near` has
    /// it, with the objects of that.
    ModelPointer get(KeptModel &kept, const Model &near);
    void clear();
    /// Of those that are held, the newest left out.
    std::size_t bytes() const { return m_bytes; }

private:
    struct Held
    {
        ModelPointer model;
        bool isWeighed = false;
    };
    struct Weighed
    {
        int uses = 0;
        std::size_t bytes = 0;
    };
    void touch(const ModelPointer &model);
    void weigh(const Model &model);
    void release(const Model &model);
    template <class Visit>
    void eachResult(const Model &model, Visit visit);

    std::size_t m_room, m_bytes = 0;
    std::list<Held> m_held; // most recently asked for first
    std::unordered_map<const void *, Weighed> m_weighed;
};

} // namespace fff
