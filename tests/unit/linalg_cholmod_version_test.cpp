#include <gtest/gtest.h>

#include "linalg/cholmod_handles.hpp"

namespace {

using namespace bempd::linalg;

TEST(Cholmod, of_another_main_version_is_refused_in_a_sentence) {
  EXPECT_NO_THROW(CholmodCommon());
  try {
    require_cholmod(CHOLMOD_MAIN_VERSION + 1);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("CHOLMOD " + std::to_string(CHOLMOD_MAIN_VERSION + 1) + " runs"), std::string::npos)
        << message;
    EXPECT_NE(message.find("compile bempd again"), std::string::npos) << message;
  }
}

}  // namespace
