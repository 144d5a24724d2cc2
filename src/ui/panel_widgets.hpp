// One widget for each kind of field.
#pragma once

#include "ui/panel_editor.hpp"

#include <span>
#include <string_view>

namespace knotwork::ui {

/// A label on the left, its help on hovering it; the widget that follows fills the rest of the row.
void rowLabel(std::string_view label, std::string_view help);
/// The reason under a field, in the colour of errors; nothing for an empty one.
void refusalText(std::string_view reason, const Theme& colours);
/// A field with its label, its widget and, where its last edit was refused, the reason.
void fieldRow(PanelEditor& editor, const scene::PanelField& field);

/// Flags two in a row, each with its label behind it.
void flagGrid(PanelEditor& editor, std::span<const scene::PanelField> flags);

/// Whether a field is a list, which stands under a heading of its own.
[[nodiscard]] bool isList(scene::FieldKind kind) noexcept;
/// Points, numbers (knots, weights, samples) or poses: a row each, with add and remove.
void listRows(PanelEditor& editor, const scene::PanelField& field);

/// Drags numbers from side to side: `values` are changed in place.
[[nodiscard]] bool dragNumbers(std::span<double> values, double speed);
/// The sign of a choice, at the right end of the combo box that was the last item (which was begun
/// without an arrow of its own).
void drawChevron();
/// A track with a round knob, and the number behind it for exact dragging and typing.
[[nodiscard]] bool slideNumber(double& value, double low, double high);
/// How far a pixel of dragging moves a number of this size.
[[nodiscard]] double dragSpeed(double value) noexcept;

}  // namespace knotwork::ui
