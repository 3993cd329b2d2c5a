#include "ui/dialogs/cut_time.h"

#include "core/fabrication/cutting_order.h"
#include "ui/dialogs/export_choices.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct CutTimeTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::CutTime)
};

constexpr double kMinute = 60.0; // s

double secondsOf(const CuttingDrawing &drawing, const CutFinish &finish, const Machine &machine)
{
    ToolWay way;
    for (CuttingSheet sheet : drawing.sheets) {
        sheet.finish = finish;
        way += wayAlong(inCuttingOrder(sheet), machine);
    }
    return way.seconds;
}

} // namespace

QString CutTime::text(const CuttingWork &work, const ExportChoices &choices)
{
    if (work.made() != m_made || choices.machine != m_machine) {
        m_made = work.made();
        m_machine = choices.machine;
        m_seconds.reset();
        const std::shared_ptr<const Machine> machine = choices.chosenMachine();
        if (const Cutting *cutting = work.cutting())
            m_seconds =
                secondsOf(cutting->drawing, m_made->finish, machine ? *machine : usualMachine());
    }
    //: how long a machine cuts
    return m_seconds ? CutTimeTexts::tr("about %n min", nullptr,
                                        static_cast<int>(std::ceil(*m_seconds / kMinute)))
                     : QString();
}

} // namespace fff::ui
