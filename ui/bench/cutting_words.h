// What is to be looked out for in what is cut, in sentences.
#pragma once

#include "core/analysis/cutting.h"

#include <QLocale>
#include <QString>

#include <vector>

namespace fff::ui {

struct CuttingRemark
{
    QString text;
    std::string section; // that it is about, by name
};

std::vector<CuttingRemark> cuttingRemarks(const Cutting &cutting);

// "38 parts", "1 sheet", "12 sections"
QString partCountText(int count);
QString sheetCountText(int count);
QString sectionCountText(int count);
/// How far the machine cuts: "7.5 m"; "24.6 ft" for who counts in inches.
QString cutLengthText(double millimetres, const QLocale &locale);

} // namespace fff::ui
