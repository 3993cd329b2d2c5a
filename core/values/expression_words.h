// What is said of expressions that cannot be read or have no worth.
#pragma once

#include "core/base/text.h"

namespace fff::expression_words {

inline constexpr Text kEmpty = FFF_TEXT("Values", "A number, a name or a sum is missing.");
inline constexpr Text kTooLong =
    FFF_TEXT("Values", "An expression has no more than %1 letters; this one is longer.");
//: numbers, names and signs such as +
inline constexpr Text kTooMuch =
    FFF_TEXT("Values", "At “%1” the expression has more than %2 numbers, names and signs.");
inline constexpr Text kTooDeep =
    FFF_TEXT("Values", "At “%1” more than %2 parentheses or signs stand in each other.");
inline constexpr Text kUnreadable = FFF_TEXT("Values", "“%1” cannot be read here.");
inline constexpr Text kNothingBehind = FFF_TEXT("Values", "Something is missing after “%1”.");
inline constexpr Text kNothingBefore = FFF_TEXT("Values", "Something is missing before “%1”.");
inline constexpr Text kNothingBetween =
    FFF_TEXT("Values", "Between “%1” and “%2” a sign is missing, such as + or *.");
inline constexpr Text kOpenParenthesis =
    FFF_TEXT("Values", "The parenthesis at “%1” is not closed.");
inline constexpr Text kLooseParenthesis =
    FFF_TEXT("Values", "After “%1” there is one closing parenthesis too many.");
inline constexpr Text kOpenText = FFF_TEXT("Values", "The text at “%1” has no closing quote.");
inline constexpr Text kOneNumberOrTwo =
    FFF_TEXT("Values", "“%1” can be one number or two: write a point, or a blank after the comma.");
inline constexpr Text kUnitAlone =
    FFF_TEXT("Values", "“%1” is a unit; a number belongs before it.");
inline constexpr Text kRaisedUnit =
    FFF_TEXT("Values", "“%1” can be meant in two ways: put “%2” in parentheses.");
inline constexpr Text kTwoComparisons =
    FFF_TEXT("Values", "“%1” is a second comparison; and(…; …) joins two of them.");
inline constexpr Text kNoFunction = FFF_TEXT("Values", "There is no function named “%1”.");
inline constexpr Text kNeedsExactly =
    FFF_TEXT("Values", "“%1” takes %2 between its parentheses, not %3.");
inline constexpr Text kNeedsAtLeast =
    FFF_TEXT("Values", "“%1” takes at least %2 between its parentheses, not %3.");
inline constexpr Text kNeedsAtMost =
    FFF_TEXT("Values", "“%1” takes at most %2 between its parentheses, not %3.");

inline constexpr Text kUnknownName = FFF_TEXT("Values", "There is no value named “%1”.");
inline constexpr Text kNoThickness =
    FFF_TEXT("Values", "“%1” is the thickness of the stock; there is no single stock here.");
inline constexpr Text kHasUnit =
    FFF_TEXT("Values", "“%1” is %2, so it cannot have a unit of its own.");
//: %2 and %4: such as “a length”
inline constexpr Text kUnlike =
    FFF_TEXT("Values", "“%1” is %2 and “%3” is %4; only what is alike can be added or compared.");
inline constexpr Text kNotANumber =
    FFF_TEXT("Values", "“%1” is %2; nothing can be calculated with it.");
//: %2 and %3: such as “a length”
inline constexpr Text kNeeds = FFF_TEXT("Values", "“%1” is %2; what is needed here is %3.");
inline constexpr Text kNoExponent = FFF_TEXT(
    "Values", "“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.");
inline constexpr Text kTooManyPowers =
    FFF_TEXT("Values", "“%1” multiplies too many lengths, angles or masses.");
inline constexpr Text kNoRoot = FFF_TEXT("Values", "“%1” is %2, which has no square root.");

inline constexpr Text kDividedByNothing =
    FFF_TEXT("Values", "“%1” is 0, and nothing can be divided by 0.");
inline constexpr Text kRootOfNegative =
    FFF_TEXT("Values", "“%1” is negative and has no square root.");
inline constexpr Text kNoTangent = FFF_TEXT("Values", "The tangent of “%1” is infinite.");
inline constexpr Text kBeyondOne =
    FFF_TEXT("Values", "“%1” is not between −1 and 1, so it belongs to no angle.");
inline constexpr Text kNoPower = FFF_TEXT("Values", "“%1” is no number.");
inline constexpr Text kNoStep =
    FFF_TEXT("Values", "“%1” is not above 0, and nothing can be rounded to steps of that.");
inline constexpr Text kTooLarge = FFF_TEXT("Values", "“%1” is too large.");

//: %2: a number
inline constexpr Text kNotWhole =
    FFF_TEXT("Values", "“%1” is %2, not a whole number; round, floor or ceil make it one.");
//: %2 and %3: lengths, masses, angles or numbers
inline constexpr Text kBelowRange = FFF_TEXT("Values", "“%1” is %2; it has to be at least %3.");
inline constexpr Text kAboveRange = FFF_TEXT("Values", "“%1” is %2; it can be at most %3.");
inline constexpr Text kNoChoice = FFF_TEXT("Values", "“%1” is “%2”, which is none of the choices.");
inline constexpr Text kTooLongText =
    FFF_TEXT("Values", "“%1” makes a text of more than %2 letters.");
//: %1: such as “a → b → a”
inline constexpr Text kCircle = FFF_TEXT("Values", "This value is made of itself: %1.");
inline constexpr Text kFollows =
    FFF_TEXT("Values", "This value is made of “%1”, which has none at the moment.");
inline constexpr Text kNamedTwice = FFF_TEXT("Values", "Two values are named “%1”.");

inline constexpr Text kNoName = FFF_TEXT(
    "Values", "“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.");
inline constexpr Text kTakenName =
    FFF_TEXT("Values", "“%1” cannot be a name, as it means something in expressions.");
inline constexpr Text kNoSuchValue = FFF_TEXT("Values", "This value is not there any more.");

inline constexpr Text kOpenBrace = FFF_TEXT("Values", "The brace at “%1” is not closed.");

} // namespace fff::expression_words
