// Copying: through a clipboard, which other windows and programs read, and in place.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

#include <functional>
#include <string>

namespace fff::hints {

inline constexpr Text kNothingToPaste =
    FFF_TEXT("Hint", "Nothing pasted: what was copied has neither sections nor a picture in it.");

} // namespace fff::hints

namespace fff {

/// What is copied is the text of a `.fff` file.
struct Clipboard
{
    std::function<std::string()> read;
    std::function<void(const std::string &)> write;
};

/// One of its own, which no other program sees.
Clipboard memoryClipboard();

/// edit.copy, edit.cut    what is selected, with what is between it; with a selected operation what
///                        that is made of
/// edit.paste             where it was; beside what is there already. Says so when there is nothing
/// edit.duplicate         without the clipboard, beside the original
/// edit.mirrorCopyX, edit.mirrorCopyY, edit.mirrorCopyZ   across the plane where that is 0
/// edit.mirrorCopySection section: a name; without it, asked for in the view: across its plane
/// What comes is selected. The session and the interaction outlive the registry.
void registerCopyCommands(CommandRegistry &registry, Session &session, Interaction &interaction,
                          Clipboard clipboard);

} // namespace fff
