// A number for what a button is to do: nobody else knows of it, so its row keeps it.
#pragma once

#include "ui/properties/property_rows.h"
#include "ui/properties/slider_field.h"

namespace fff::ui {

struct KeptRange
{
    int least, slid, most; // of the field; its slider ends at the one between
    QString unit = {};
    int notches = 4; // of the slider, that a page of it goes
};

struct KeptNumber
{
    PropertyRow *row = nullptr;
    SliderField *field = nullptr;
};

/// At the group's end. kept: outlives it
KeptNumber addKeptNumber(PropertyGroup &group, const QString &name, const char *id,
                         const KeptRange &range, int *kept);

} // namespace fff::ui
