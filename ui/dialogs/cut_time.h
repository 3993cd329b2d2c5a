// How long a machine cuts, worked out once for what is made and the machine that is chosen.
#pragma once

#include "ui/dialogs/cutting_work.h"

#include <QString>

#include <memory>
#include <optional>

namespace fff::ui {

struct ExportChoices;

class CutTime
{
public:
    /// "about 9 min", by the usual machine where none is chosen; empty where nothing can be cut.
    QString text(const CuttingWork &work, const ExportChoices &choices);

private:
    std::shared_ptr<const CuttingWork::Made> m_made; // that it is of
    QString m_machine;
    std::optional<double> m_seconds;
};

} // namespace fff::ui
