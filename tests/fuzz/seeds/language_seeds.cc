#include "fuzz/seeds/seeds.h"
#include "language/local/tiny_model.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/sentences/sentence_grammar.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld::fuzz {
namespace {

// A lake in a meadow.
SymbolicLayout LakeLayout(Vocabulary vocabulary) {
  SymbolicLayout layout = {vocabulary, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  for (int row = 12; row < 20; ++row) {
    for (int col = 10; col < 22; ++col) layout.cells(row, col) = 'W';
  }
  return layout;
}

EnvironmentConfig WinterEnvironment() {
  EnvironmentConfig environment;
  environment.coarse.season = Season::kWinter;
  environment.fine = DeriveFineAttributes(environment.coarse);
  AgentGroup sheep;
  sheep.category = AgentCategory::kSheep;
  sheep.quantity = 3;
  environment.agents = {sheep};
  return environment;
}

}  // namespace

void LanguageSeeds(const TakeSeed& take) {
  for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const std::string name(NameOf(vocabulary));
    const std::string text = ToText(LakeLayout(vocabulary));
    take("layout_text", name, text);
    take("model_answer", name, (vocabulary == Vocabulary::kSuburb ? "a" : "b") + text);
  }
  take("environment_json", "winter", ToJson(WinterEnvironment()));
  take("environment_json", "plain", ToJson(EnvironmentConfig()));
  take("model_answer", "environment",
       "c<think>{}</think>\n```json\n" + ToJson(EnvironmentConfig()));
  for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
    const std::string name = kind == SentenceKind::kLayout ? "layout" : "environment";
    std::string all;
    for (const SentenceForm& form : SentenceForms(kind)) all += form.example + "\n";
    take("small_language", name + "_forms", all);
    take("instruction", name + "_forms", all);
    take("gbnf", name + "_sentences", SentenceGrammar(kind) + "\n---\n" + all.substr(0, 64));
  }
  take("gbnf", "layout", LayoutForm(Vocabulary::kWild).gbnf + "\n---\n");
  take("schema_grammar", "sentences", SentencesForm("sentences").json_schema);
  take("schema_grammar", "layout", LayoutForm(Vocabulary::kWild).json_schema);
  TinyModel model;
  model.weight_type = 1;
  model.layers = 1;
  model.width = 8;
  model.heads = 2;
  model.kv_heads = 1;
  model.hidden = 8;
  model.context = 64;
  model.chat_template = "<|im_start|>";
  take("gguf", "tied", (model.ties_output = true, TinyGguf(model)));
}

}  // namespace latticeworld::fuzz
