#include "nff/nffSkipped.h"

#include <algorithm>

namespace sw {

bool skipOldStatement(NffShapes& shapes) {
    NffTokens& tokens = shapes.tokens;
    const NffToken word = tokens.last();
    const int count = word.text == "number" ? 1 : word.text == "g" ? 6 : 0;
    if (count == 0) return false;
    float unused[6];
    tokens.numbers({word.text, count}, unused, count);
    shapes.warn(word.begin(), std::string(word.text) + " is a statement of 1990",
                "skipped; statements number and g in this file: ");
    return true;
}

// Whether the next token is on the line of the last one.
static bool isOnSameLine(const NffTokens& tokens) {
    return !tokens.atEnd() && std::none_of(tokens.last().end(), tokens.peek().begin(), isLineEnd);
}

void skipTexture(NffShapes& shapes, const char* statement) {
    if (!isOnSameLine(shapes.tokens) || shapes.tokens.atNumber()) return;
    NffTokens ahead = shapes.tokens;
    if (ahead.take().text == "v" || isOnSameLine(ahead) || ahead.atNumber()) return;  // a keyword
    shapes.tokens.take();
    shapes.warn(statement, "the name behind the material's numbers is not used",
                "textures are not part of the format; such names in this file: ");
}

}  // namespace sw
