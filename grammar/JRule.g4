// The grammar of .jrule files; README.md says what the constructs mean.
//
// Every decision but one needs one token of lookahead (a node's `<0,1>` against an arc's `<-0-` needs two), so that
// parsing is linear and an error is found at the token that is wrong. Where that makes the grammar wider than the
// language, the AST builder narrows it: `f[2](x)` is parsed as suffixes of `f`, `name: value` as an expression before
// the colon.
// Repetition is written as loops where a user could write long chains, so that recursion follows brackets only.
grammar JRule;

// One item of a file: the compiler splits files into items first, so that an error in one cannot swallow another.
item
  : (importItem | modelItem | modelerItem | ruleItem | operationItem | externItem) EOF
  ;

name : NAME ;

// ---- Modules ----

importItem : 'import' moduleName ('.' moduleName)* ';' ;

moduleName : NAME | 'vertex' | 'edge' | 'face' | 'volume' | 'connected' | 'cell' ;

// ---- Models and modelers ----

modelItem : 'model' name ('(' name ')')? '{' modelStatement* '}' ;

modelStatement
  : 'dimensions' dimensionRange (',' dimensionRange)* ';'
  | 'oriented' dimensionRange (',' dimensionRange)* ';'
  | 'exchange' dimensionPair ('where' expression | (',' dimensionPair)*) ';'
  | 'closed' ';'
  ;

dimensionRange : dimension ('..' dimension)? ;
dimensionPair  : '(' dimension ',' dimension ')' ;

modelerItem : 'modeler' name 'on' modelReference (';' | '{' embedding* '}') ;

modelReference : name ('(' dimension ')')? ;

embedding : 'embedding' name ':' orbitType '->' typeName (';' | '{' policy* '}' ';'?) ;

policy
  : 'default' expression ';'
  | 'merge' name ';'
  ;

typeName : name | '[' name ']' ;

// ---- Dimensions, words, orbit types ----

dimension     : dimensionTerm (('+' | '-') dimensionTerm)* ;
dimensionTerm : INT | NAME ;

letter : '~'? dimension ;
word   : '[' (letter (',' letter)*)? ']' ;

orbitElement
  : '_'
  | '~' dimension
  | dimensionRange
  | word
  ;
elementList : '<' (orbitElement (',' orbitElement)*)? '>' ;

orbitType
  : elementList
  | 'vertex'
  | 'edge'
  | 'face'
  | 'volume'
  | 'connected'
  | 'cell' '(' dimension ')'
  ;

// ---- Rules ----

ruleItem
  : 'rule' name ('[' name (',' name)* ']')? parameters? 'on' modelReference
    '{' 'left' side 'right' side expectation* '}'
  ;

parameters : '(' (parameter (',' parameter)*)? ')' ;
parameter  : name ':' typeName ('=' expression)? ;

side : '{' sideItem* '}' ;

sideItem
  : 'hook' name node
  | name (node | arc+ ';')
  | let
  | 'require' expression ';'
  ;

node : elementList? (';' | '{' clause* '}' ';'?) ;

clause : name '=' expression ';' ;

arc
  : '-' arcDimension word? ('-' | '->') name
  | '<' '-' arcDimension word? '-' name
  ;
arcDimension : INT | NAME | '(' dimension ')' ;

let : 'let' name '=' expression ';' ;

expectation : 'expect' COUNT '=' expression ';' ;

// ---- C++ from outside ----

externItem
  : 'extern' ('type' name | 'fn' name parameters '->' typeName) 'in' STRING 'as' STRING ';'
  ;

// ---- Operations ----

operationItem : 'operation' name parameters? 'on' modelReference ('->' typeName)? block ;

block : '{' statement* '}' ;

statement
  : let
  | ifStatement
  | 'for' name 'in' expression block
  | 'while' expression block
  | 'return' expression? ';'
  | 'fail' STRING ';'
  | 'try' block 'else' block
  | 'apply_all' expression 'on' expression ';'
  | disjunction ('=' expression)? ';'  // not `expression`: `if` begins a statement here
  ;

ifStatement : 'if' expression block elseBranch* ;
elseBranch  : 'else' ('if' expression)? block ;

// ---- Expressions, loosest first ----

expression  : ('if' expression 'then' expression 'else')* disjunction ;
disjunction : conjunction ('or' conjunction)* ;
conjunction : negation ('and' negation)* ;
negation    : 'not'* comparison ;
comparison  : addition (('<' | '<=' | '>' | '>=' | '==' | '!=') addition)? ;
addition    : multiplication (('+' | '-') multiplication)* ;
multiplication : unary (('*' | '/') unary)* ;
unary       : '-'* postfix ;
postfix     : primary suffix* ;

suffix
  : '.' name
  | '@' (word | '~'? (INT | NAME))
  | '[' expression (',' expression)* ']'
  | '(' (argument (',' argument)*)? ')'
  ;

argument : expression (':' expression | 'for' name 'in' expression)? ;

primary
  : INT
  | REAL
  | STRING
  | 'true'
  | 'false'
  | name
  | '(' expression ')'
  | orbitType '(' expression ')' ('by' orbitType)?
  ;

// ---- Tokens ----

KW_IMPORT : 'import' ;
KW_MODEL : 'model' ;
KW_DIMENSIONS : 'dimensions' ;
KW_ORIENTED : 'oriented' ;
KW_EXCHANGE : 'exchange' ;
KW_WHERE : 'where' ;
KW_CLOSED : 'closed' ;
KW_MODELER : 'modeler' ;
KW_EMBEDDING : 'embedding' ;
KW_DEFAULT : 'default' ;
KW_MERGE : 'merge' ;
KW_RULE : 'rule' ;
KW_ON : 'on' ;
KW_LEFT : 'left' ;
KW_RIGHT : 'right' ;
KW_HOOK : 'hook' ;
KW_REQUIRE : 'require' ;
KW_LET : 'let' ;
KW_EXPECT : 'expect' ;
KW_EXTERN : 'extern' ;
KW_TYPE : 'type' ;
KW_FN : 'fn' ;
KW_IN : 'in' ;
KW_AS : 'as' ;
KW_OPERATION : 'operation' ;
KW_IF : 'if' ;
KW_THEN : 'then' ;
KW_ELSE : 'else' ;
KW_FOR : 'for' ;
KW_BY : 'by' ;
KW_WHILE : 'while' ;
KW_RETURN : 'return' ;
KW_FAIL : 'fail' ;
KW_TRY : 'try' ;
KW_APPLY_ALL : 'apply_all' ;
KW_AND : 'and' ;
KW_OR : 'or' ;
KW_NOT : 'not' ;
KW_TRUE : 'true' ;
KW_FALSE : 'false' ;
KW_VERTEX : 'vertex' ;
KW_EDGE : 'edge' ;
KW_FACE : 'face' ;
KW_VOLUME : 'volume' ;
KW_CONNECTED : 'connected' ;
KW_CELL : 'cell' ;

REMOVED : '_' ;
NAME : [A-Za-z_] [A-Za-z0-9_]* ;
COUNT : [A-Za-z_] [A-Za-z0-9_]* '\'' ;  // `V'`: what `expect` speaks of

// A real has a digit after its dot, so that `0..2` and `a@0.position` need no spaces.
REAL : DIGITS '.' DIGITS EXPONENT? | DIGITS EXPONENT ;
INT : DIGITS ;
fragment DIGITS : [0-9]+ ;
fragment EXPONENT : [eE] [+\-]? DIGITS ;

STRING : OPEN_STRING '"' ;
UNCLOSED_STRING : OPEN_STRING '\\'? ;
fragment OPEN_STRING : '"' (~["\\\r\n] | '\\' ~[\r\n])* ;

LBRACE : '{' ;
RBRACE : '}' ;
LPAREN : '(' ;
RPAREN : ')' ;
LBRACKET : '[' ;
RBRACKET : ']' ;
SEMICOLON : ';' ;
COMMA : ',' ;
COLON : ':' ;
RANGE : '..' ;
DOT : '.' ;
AT : '@' ;
TILDE : '~' ;
ARROW : '->' ;
EQUAL : '==' ;
NOT_EQUAL : '!=' ;
LESS_EQUAL : '<=' ;
GREATER_EQUAL : '>=' ;
LESS : '<' ;
GREATER : '>' ;
ASSIGN : '=' ;
PLUS : '+' ;
MINUS : '-' ;
STAR : '*' ;
SLASH : '/' ;

DOC : '///' (~[/\r\n] ~[\r\n]*)? -> channel(HIDDEN) ;
LINE_COMMENT : '//' ~[\r\n]* -> channel(HIDDEN) ;
BLOCK_COMMENT : '/*' .*? '*/' -> channel(HIDDEN) ;
SPACE : [ \t\r\n\f]+ -> skip ;

// Anything else: the lexer itself never fails.
UNEXPECTED : . ;
