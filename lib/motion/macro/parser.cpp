#include "macro/parser.hpp"

#include "macro/expressions.hpp"

#include <algorithm>
#include <utility>

namespace filum::macro {

namespace {

class TemplateReader {
  public:
    TemplateReader(std::string_view text, Style style) : in_(text), style_(style) {}

    Block all() {
        Block out = text_block(false);
        if (!in_.done()) in_.fail("'{" + ahead() + "}' has no '{if}' before it");
        return out;
    }

  private:
    static bool goes_on(std::string_view word) { return word == "elsif" || word == "else" || word == "endif"; }

    // The name or keyword after a brace; the cursor stays.
    std::string ahead() {
        const std::size_t at = in_.at();
        in_.step();
        std::string out = in_.peek_name();
        in_.move(at);
        return out;
    }

    static void add_text(std::string_view text, std::size_t at, Block& to) {
        if (text.empty()) return;
        if (!to.empty() && to.back().kind == TemplateNode::Kind::text) {
            to.back().text += text;
            return;
        }
        TemplateNode piece;
        piece.text = text;
        piece.at = at;
        to.push_back(std::move(piece));
    }

    // Reads text and braces, up to the brace of an elsif, else or endif.
    Block text_block(bool within) {
        if (++depth_ > kDeepestTemplate) in_.fail("its conditions are nested too deep");
        Block out;
        while (!in_.done()) {
            const std::size_t at = in_.at();
            const std::size_t end =
                std::min(in_.text().find_first_of(style_ == Style::own ? "{}" : "{[", at), in_.text().size());
            add_text(in_.text().substr(at, end - at), at, out);
            in_.move(end);
            if (in_.done()) break;
            if (style_ == Style::own && in_.peek(1) == in_.peek()) { // {{ or }}
                add_text(in_.text().substr(end, 1), end, out);
                in_.step(2);
            } else if (in_.peek() == '}') {
                in_.fail("'}' has no '{' before it");
            } else if (in_.peek() == '[') {
                out.push_back(bracket());
            } else {
                if (goes_on(ahead())) break;
                in_.step();
                braces(out);
            }
        }
        if (within && in_.done()) in_.fail("'{endif}' is missing");
        --depth_;
        return out;
    }

    // Reads [name] or [name[index]].
    TemplateNode bracket() {
        TemplateNode out;
        out.kind = TemplateNode::Kind::bracket;
        out.at = in_.at();
        in_.step();
        out.text = in_.name("in [...]");
        if (in_.take("[")) {
            out.index = in_.name("as an index in [...]");
            in_.need(']', "behind an index");
        }
        in_.need(']', "behind a name in [...]");
        return out;
    }

    // Reads the rest of a pair of braces, after the opening one.
    void braces(Block& out) {
        const std::size_t at = in_.at() - 1;
        bool any = false;
        for (;; any = true) {
            while (in_.take(";")) any = true;
            if (any && in_.take("}")) return;
            if (in_.done()) throw FaultAt{"'{' has no '}' behind it", at};
            if (in_.take_word("if")) {
                out.push_back(branch());
                continue;
            }
            out.push_back(statement());
            if (!in_.take(";") && in_.peek() != '}') in_.fail("'}' is missing behind an expression");
        }
    }

    // Reads the rest of an `if`: conditions and their blocks, up to endif.
    TemplateNode branch() {
        if (++depth_ > kDeepestTemplate) in_.fail("its conditions are nested too deep");
        TemplateNode out;
        out.kind = TemplateNode::Kind::branch;
        out.at = in_.at();
        for (bool last = false;;) {
            if (!last) out.branch.conditions.push_back(parse_expression(in_, depth_));
            if (in_.take("}")) {
                out.branch.blocks.push_back(text_block(true));
                in_.step(); // skips the brace before elsif, else or endif
            } else if (last || in_.take_word("then")) {
                out.branch.blocks.push_back(code_block());
            } else {
                in_.fail("'}' or 'then' is missing behind a condition");
            }
            if (in_.take_word("endif")) break;
            if (last) in_.fail("'endif' is missing behind 'else'");
            last = in_.take_word("else");
            if (!last && !in_.take_word("elsif")) in_.fail("'endif' is missing");
        }
        --depth_;
        return out;
    }

    // Reads statements without braces, up to elsif, else or endif.
    Block code_block() {
        Block out;
        for (;;) {
            while (in_.take(";")) {
            }
            if (goes_on(in_.peek_name())) return out;
            if (in_.done()) in_.fail("'endif' is missing");
            if (in_.take_word("if")) {
                out.push_back(branch());
                continue;
            }
            out.push_back(statement());
            if (!in_.take(";") && !goes_on(in_.peek_name())) in_.fail("';' is missing behind a statement");
        }
    }

    TemplateNode statement() {
        in_.blanks();
        TemplateNode out;
        out.at = in_.at();
        const bool local = in_.take_word("local"), global = !local && in_.take_word("global");
        if (local || global || assigns()) {
            out.kind = TemplateNode::Kind::assignment;
            out.assignment = assignment(local    ? Assignment::Scope::local
                                        : global ? Assignment::Scope::global
                                                 : Assignment::Scope::known);
            return out;
        }
        out.kind = TemplateNode::Kind::expression;
        out.expression = parse_expression(in_, depth_);
        return out;
    }

    // True if "name =" or "name[index] =" follows.
    bool assigns() {
        const std::size_t at = in_.at();
        const std::string name = in_.peek_name();
        bool out = false;
        if (!name.empty() && !is_keyword(name)) {
            in_.step(name.size());
            if (in_.take("["))
                for (int open = 1; open > 0 && !in_.done(); in_.step())
                    open += in_.peek() == '[' ? 1 : in_.peek() == ']' ? -1 : 0;
            in_.blanks();
            out = in_.peek() == '=' && in_.peek(1) != '=' && in_.peek(1) != '~';
        }
        in_.move(at);
        return out;
    }

    Assignment assignment(Assignment::Scope scope) {
        Assignment out;
        out.scope = scope;
        out.name = in_.name("before '='");
        if (in_.take("[")) {
            out.index.push_back(parse_sum(in_, depth_));
            in_.need(']', "behind an index");
        }
        in_.need('=', "in an assignment");
        if (in_.take_word("repeat")) {
            out.repeat = true;
            in_.need('(', "behind 'repeat'");
            out.values.push_back(parse_expression(in_, depth_));
            in_.need(',', "between the count and the value of 'repeat'");
            out.values.push_back(parse_expression(in_, depth_));
            in_.need(')', "behind 'repeat'");
        } else {
            values(out);
        }
        return out;
    }

    // Reads the right side of an assignment.  "(a, b)" is a list; "(a) + b" is an expression.
    void values(Assignment& out) {
        in_.blanks();
        const std::size_t at = in_.at();
        if (in_.take("(")) {
            out.list = true;
            while (!in_.take(")")) {
                if (!out.values.empty()) in_.need(',', "between the values of a list");
                out.values.push_back(parse_expression(in_, depth_));
            }
            in_.blanks();
            if (in_.done() || in_.peek() == ';' || in_.peek() == '}' || goes_on(in_.peek_name())) return;
            in_.move(at);
            out.list = false;
            out.values.clear();
        }
        out.values.push_back(parse_expression(in_, depth_));
    }

    Cursor in_;
    Style style_;
    int depth_ = 0;
};

} // namespace

Block parse(std::string_view text, Style style) { return TemplateReader(text, style).all(); }

Fault placed(const FaultAt& fault, std::string_view text) {
    const std::string_view before = text.substr(0, std::min(fault.at, text.size()));
    const auto line_end = before.rfind('\n');
    return {fault.why, 1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
            1 + before.size() - (line_end == std::string_view::npos ? 0 : line_end + 1)};
}

} // namespace filum::macro
