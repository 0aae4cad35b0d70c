#include "latticeworld/language/chat/kept_form.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

AnswerForm SomeForm() {
  AnswerForm form;
  form.name = "form";
  form.gbnf = "root ::= [AB]{2}";
  form.regex = "[AB]{2}";
  form.json_schema = R"({"type":"object","properties":{"a":{},"b":{}},"required":["a"],)"
                     R"("additionalProperties":false})";
  return form;
}

KeptForm Judge(const std::string& text, FormLanguage language, bool whole = true) {
  return KeepsForm(text, whole, SomeForm(), language);
}

TEST(KeptFormTest, JsonIsInFormWithTheMembersThatTheSchemaWants) {
  const auto schema = FormLanguage::kJsonSchema;
  EXPECT_EQ(Judge(R"({"a":1})", schema), KeptForm::kYes);
  EXPECT_EQ(Judge("\n "
                  R"({ "b": 2, "a": 1 })"
                  " \n",
                  schema),
            KeptForm::kYes);
  for (const char* text : {"Sure! {\"a\":1}", "```json\n{\"a\":1}\n```", "{\"b\":1}", "[1]",
                           "{\"a\":1,\"c\":2}", "{\"a\":", "hm, hm", "{\"a\":1}{\"a\":1}"}) {
    EXPECT_EQ(Judge(text, schema), KeptForm::kNo) << text;
  }
}

TEST(KeptFormTest, AGrammarIsJudgedByTheRegularExpressionBesideIt) {
  for (const auto language : {FormLanguage::kGbnf, FormLanguage::kRegex}) {
    EXPECT_EQ(Judge("AB\n", language), KeptForm::kYes);
    EXPECT_EQ(Judge("ABA", language), KeptForm::kNo);
    EXPECT_EQ(Judge("Here: AB", language), KeptForm::kNo);
    AnswerForm no_regex = SomeForm();
    no_regex.regex.clear();
    EXPECT_EQ(KeepsForm("ABA", true, no_regex, language), KeptForm::kUnknown);
  }
}

TEST(KeptFormTest, ACutAnswerIsOutOfFormOnlyWhereNothingMoreCouldMendIt) {
  EXPECT_EQ(Judge("{\"a\":", FormLanguage::kJsonSchema, false), KeptForm::kUnknown);
  EXPECT_EQ(Judge("ABAB", FormLanguage::kJsonSchema, false), KeptForm::kNo);
  EXPECT_EQ(Judge("A", FormLanguage::kGbnf, false), KeptForm::kUnknown);
}

TEST(KeptFormTest, SaysNothingWhereNoFormWasToldOrNothingWasSaid) {
  EXPECT_EQ(Judge("hm", FormLanguage::kNone), KeptForm::kUnknown);
  EXPECT_EQ(Judge(" \n", FormLanguage::kJsonSchema), KeptForm::kUnknown);
  EXPECT_EQ(KeepsForm("hm", true, {}, FormLanguage::kJsonSchema), KeptForm::kUnknown);
}

}  // namespace
}  // namespace latticeworld
