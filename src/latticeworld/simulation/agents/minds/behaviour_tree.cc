#include "latticeworld/simulation/agents/minds/behaviour_tree.h"

namespace latticeworld {
namespace {

class FirstOfPieces : public BehaviourPiece {
 public:
  explicit FirstOfPieces(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

  std::optional<Steering> Try(Agent* agent, Surroundings* world) const override {
    for (const Piece& piece : pieces_) {
      if (auto steering = piece->Try(agent, world)) return steering;
    }
    return std::nullopt;
  }
  std::string name() const override { return "first of"; }
  std::vector<const BehaviourPiece*> children() const override {
    std::vector<const BehaviourPiece*> children;
    children.reserve(pieces_.size());
    for (const Piece& piece : pieces_) children.push_back(piece.get());
    return children;
  }

 private:
  const std::vector<Piece> pieces_;
};

class GatedPiece : public BehaviourPiece {
 public:
  GatedPiece(std::string name, Gate gate, Piece piece)
      : name_(std::move(name)), gate_(std::move(gate)), piece_(std::move(piece)) {}

  std::optional<Steering> Try(Agent* agent, Surroundings* world) const override {
    if (!gate_(agent, world)) return std::nullopt;
    return piece_->Try(agent, world);
  }
  std::string name() const override { return name_; }
  std::vector<const BehaviourPiece*> children() const override { return {piece_.get()}; }

 private:
  const std::string name_;
  const Gate gate_;
  const Piece piece_;
};

class DoPiece : public BehaviourPiece {
 public:
  DoPiece(std::string name, Action action) : name_(std::move(name)), action_(action) {}

  std::optional<Steering> Try(Agent* agent, Surroundings* world) const override {
    return action_(agent, world);
  }
  std::string name() const override { return name_; }

 private:
  const std::string name_;
  const Action action_;
};

// Draws the piece and all below it; answers its number.
int Draw(const BehaviourPiece& piece, int* count, std::string* text) {
  const int number = (*count)++;
  const std::string node = "n" + std::to_string(number);
  const auto children = piece.children();
  // Leaves act: rounded. One child: a condition. More: a choice.
  const char* open = children.empty() ? "([\"" : children.size() == 1 ? "{{\"" : "[\"";
  const char* close = children.empty() ? "\"])" : children.size() == 1 ? "\"}}" : "\"]";
  *text += "  " + node + open + piece.name() + close + "\n";
  for (const BehaviourPiece* child : children) {
    const int below = Draw(*child, count, text);
    *text += "  " + node + " --> n" + std::to_string(below) + "\n";
  }
  return number;
}

}  // namespace

Piece FirstOf(std::vector<Piece> pieces) {
  return std::make_unique<FirstOfPieces>(std::move(pieces));
}

Piece Gated(std::string name, Gate gate, Piece piece) {
  return std::make_unique<GatedPiece>(std::move(name), std::move(gate), std::move(piece));
}

Piece When(std::string name, Condition condition, Piece piece) {
  return Gated(
      std::move(name),
      [condition](Agent* agent, Surroundings* world) { return condition(*agent, *world); },
      std::move(piece));
}

Piece Do(std::string name, Action action) {
  return std::make_unique<DoPiece>(std::move(name), action);
}

std::string DrawTree(const BehaviourPiece& root) {
  std::string text = "flowchart LR\n";
  int count = 0;
  Draw(root, &count, &text);
  return text;
}

}  // namespace latticeworld
