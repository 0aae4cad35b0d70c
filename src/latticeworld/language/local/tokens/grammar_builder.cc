#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "latticeworld/language/local/tokens/gbnf.h"
#include "latticeworld/language/local/tokens/grammar.h"

namespace latticeworld {
namespace {

using Expression = GrammarExpression;

constexpr std::size_t kMostNodes = 1'000'000;

}  // namespace

// Makes the automaton from behind: each expression is told what comes after it.
class GrammarBuilder {
 public:
  static Result<Grammar> Build(const std::map<std::string, Expression>& rules) {
    GrammarBuilder builder;
    if (rules.count("root") == 0) return InvalidArgument("grammar: there is no rule 'root'");
    // Calls name rules that may follow, so each has its first node before any
    // has the others.
    for (const auto& rule : rules) builder.begins_[rule.first] = builder.Add({});
    for (const auto& [name, body] : rules) {
      const Grammar::NodeId begin = builder.Make(body, builder.Add({}));
      builder.grammar_.nodes_[builder.begins_[name]] = {Grammar::Node::Kind::kSplit, 0, begin,
                                                        begin};
    }
    builder.grammar_.root_ = builder.begins_["root"];
    LW_RETURN_IF_ERROR(builder.status_);
    return std::move(builder.grammar_);
  }

 private:
  using NodeId = Grammar::NodeId;
  using Kind = Grammar::Node::Kind;

  NodeId Add(Grammar::Node node) {
    if (grammar_.nodes_.size() >= kMostNodes) {
      status_ = InvalidArgument("grammar: more than " + std::to_string(kMostNodes) + " nodes");
      return 0;
    }
    grammar_.nodes_.push_back(node);
    return static_cast<NodeId>(grammar_.nodes_.size() - 1);
  }

  std::uint32_t IndexOf(const Grammar::Bytes& bytes) {
    auto& sets = grammar_.sets_;
    const auto found = std::find(sets.begin(), sets.end(), bytes);
    if (found != sets.end()) return static_cast<std::uint32_t>(found - sets.begin());
    sets.push_back(bytes);
    return static_cast<std::uint32_t>(sets.size() - 1);
  }

  NodeId Make(const Expression& expression, NodeId next) {
    if (!status_.ok()) return next;
    switch (expression.kind) {
      case Expression::Kind::kBytes:
        return Add({Kind::kBytes, IndexOf(expression.bytes), next, 0});
      case Expression::Kind::kRule: {
        const auto found = begins_.find(expression.rule);
        if (found == begins_.end()) {
          status_ = InvalidArgument("grammar, line " + std::to_string(expression.line) +
                                    ": there is no rule '" + expression.rule + "'");
          return next;
        }
        return Add({Kind::kCall, 0, next, found->second});
      }
      case Expression::Kind::kSequence: {
        NodeId begin = next;
        for (auto part = expression.parts.rbegin(); part != expression.parts.rend(); ++part)
          begin = Make(*part, begin);
        return begin;
      }
      case Expression::Kind::kChoice: {
        NodeId begin = Make(expression.parts.back(), next);
        for (std::size_t i = expression.parts.size() - 1; i-- > 0;)
          begin = Add({Kind::kSplit, 0, Make(expression.parts[i], next), begin});
        return begin;
      }
      case Expression::Kind::kRepeat:
        return MakeRepeat(expression, next);
    }
    return next;
  }

  NodeId MakeRepeat(const Expression& repeat, NodeId next) {
    const Expression& part = repeat.parts.front();
    NodeId begin = next;
    if (repeat.most < 0) {
      begin = Add({Kind::kSplit, 0, next, next});
      const NodeId again = Make(part, begin);
      grammar_.nodes_[begin].next = again;
    }
    for (int i = repeat.least; i < repeat.most && status_.ok(); ++i)
      begin = Add({Kind::kSplit, 0, Make(part, begin), next});
    for (int i = 0; i < repeat.least && status_.ok(); ++i) {
      const NodeId made = Make(part, begin);
      // Nothing, however often, is nothing: repeats of it within each other would take for ever.
      if (made == begin) break;
      begin = made;
    }
    return begin;
  }

  std::map<std::string, NodeId> begins_;
  Grammar grammar_;
  Status status_;
};

Result<Grammar> Grammar::FromGbnf(std::string_view text) {
  LW_ASSIGN_OR_RETURN(const auto rules, ParseGbnf(text));
  return GrammarBuilder::Build(rules);
}

}  // namespace latticeworld
