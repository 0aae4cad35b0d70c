from ledger import Ledger
def run(ground, end, random):
    return Ledger("let_nobody_in")
